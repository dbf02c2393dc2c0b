// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_filter.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <utility>

// The filters of section 9 of the PNG specification. Each byte is replaced by its difference,
// modulo 256, from a prediction. The prediction is 0 (None), the byte to the left (Sub), the byte
// above (Up) or the mean of these two bytes (Average). The prediction of Paeth is one of three
// bytes: a to the left, b above, and c above and to the left. It is the byte whose value is nearest
// to a + b - c. The byte to the left is the corresponding byte of the pixel to the left. Bytes
// outside of the image count as 0. Therefore a pixel of zeros precedes each row in memory.

namespace foam::texgen {

namespace {

/// The bytes from which a filtered row is computed. `current` points to the first pixel of the
/// unfiltered row, and `above` to the first pixel of the row above it. `pixel_bytes` is the size of
/// a pixel in bytes.
struct Neighbors {
    const std::uint8_t* current;
    const std::uint8_t* above;
    std::size_t pixel_bytes;
};

/// Returns a pointer to the first pixel of a row. `row` contains a pixel of zeros, followed by the
/// pixels of the row.
const std::uint8_t* first_pixel(const Bytes& row, std::size_t pixel_bytes) {
    return reinterpret_cast<const std::uint8_t*>(row.data()) + pixel_bytes;
}

/// Writes the difference between each byte of the row and its prediction from the bytes to the
/// left, above, and above left.
template <class Predict>
void write_differences(const Neighbors& row, const Predict& predict, std::span<std::byte> out) {
    const std::uint8_t* left = row.current - row.pixel_bytes;
    const std::uint8_t* above_left = row.above - row.pixel_bytes;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const int predicted = predict(left[i], row.above[i], above_left[i]);
        out[i] = static_cast<std::byte>(row.current[i] - predicted);
    }
}

/// Returns the argument that is nearest to left + above - above_left, or the first of them if
/// several are equally near.
int paeth(int left, int above, int above_left) {
    const int to_left = std::abs(above - above_left);
    const int to_above = std::abs(left - above_left);
    const int to_above_left = std::abs(left + above - 2 * above_left);
    const int nearer_above = to_above <= to_above_left ? above : above_left;
    return to_left <= to_above && to_left <= to_above_left ? left : nearer_above;
}

void filter_row(const Neighbors& row, PngFilter filter, std::span<std::byte> out) {
    switch (filter) {
        case PngFilter::None:
            return write_differences(
                row, [](int, int, int) { return 0; }, out);
        case PngFilter::Sub:
            return write_differences(
                row, [](int left, int, int) { return left; }, out);
        case PngFilter::Up:
            return write_differences(
                row, [](int, int above, int) { return above; }, out);
        case PngFilter::Average:
            return write_differences(
                row, [](int left, int above, int) { return (left + above) / 2; }, out);
        case PngFilter::Paeth:
            return write_differences(row, paeth, out);
    }
}

}  // namespace

void PngRows::copy_row(int row, std::span<std::byte> to) const {
    assert(row >= 0 && row < height_ && to.size() == row_bytes());
    const auto from_bottom = static_cast<std::size_t>(height_ - 1 - row);
    const std::byte* from = bottom_ + from_bottom * row_bytes();
    std::memcpy(to.data(), from, to.size());
    if (sample_bytes_ == 2 && std::endian::native == std::endian::little) {
        for (std::size_t i = 0; i < to.size(); i += 2) {
            std::swap(to[i], to[i + 1]);
        }
    }
}

std::span<const std::byte> RowFilter::filter(const PngRows& rows,
                                             PngFilter filter,
                                             int first,
                                             int last) {
    const std::size_t pixel = rows.pixel_bytes();
    const std::size_t row_bytes = rows.row_bytes();
    const std::size_t size = (row_bytes + 1) * static_cast<std::size_t>(last - first);
    filtered_.resize(std::max(filtered_.size(), size));
    above_.assign(pixel + row_bytes, std::byte{0});
    current_.assign(pixel + row_bytes, std::byte{0});
    if (first > 0) {
        rows.copy_row(first - 1, std::span(above_).subspan(pixel));
    }
    std::span<std::byte> out(filtered_);
    for (int row = first; row < last; ++row, out = out.subspan(row_bytes + 1)) {
        rows.copy_row(row, std::span(current_).subspan(pixel));
        out[0] = static_cast<std::byte>(filter);
        filter_row({first_pixel(current_, pixel), first_pixel(above_, pixel), pixel},
                   filter,
                   out.subspan(1, row_bytes));
        std::swap(above_, current_);
    }
    return std::span(filtered_).first(size);
}

}  // namespace foam::texgen
