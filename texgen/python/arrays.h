// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/python/bindings.h"

#include <foamtex/records.h>

#include <memory>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Returns a read-only structured array that is a view of a vector. `owner` keeps the vector alive.
template <class Record>
pybind11::array view_of(const std::vector<Record>& records, const pybind11::handle& owner) {
    pybind11::array_t<Record> array({records.size()},
                                    {sizeof(Record)},
                                    records.data(),
                                    pybind11::reinterpret_borrow<pybind11::object>(owner));
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// Returns an array that owns an image: height x width x channels, with the top row first. The
/// samples are not copied; since row 0 of an image is the bottom row, the array runs backwards
/// through the rows of the image.
template <class Sample>
pybind11::array array_of(Image<Sample> image) {
    auto* const kept = new Image<Sample>(std::move(image));
    const pybind11::capsule owner(
        kept, [](void* pointer) { delete static_cast<Image<Sample>*>(pointer); });
    const auto pixel = static_cast<pybind11::ssize_t>(sizeof(Sample)) * kept->channels();
    const auto row = pixel * kept->width();
    return pybind11::array_t<Sample>({static_cast<pybind11::ssize_t>(kept->height()),
                                      static_cast<pybind11::ssize_t>(kept->width()),
                                      static_cast<pybind11::ssize_t>(kept->channels())},
                                     {-row, pixel, static_cast<pybind11::ssize_t>(sizeof(Sample))},
                                     kept->row(kept->height() - 1).data(),
                                     owner);
}

/// Returns a stress as an array of shape (2, 2).
inline pybind11::array matrix_of(const foamtex::Stress& stress) {
    pybind11::array_t<double> matrix({2, 2});
    auto entry = matrix.mutable_unchecked<2>();
    entry(0, 0) = stress.xx;
    entry(0, 1) = stress.xy;
    entry(1, 0) = stress.xy;
    entry(1, 1) = stress.yy;
    return matrix;
}

}  // namespace foam::texgen
