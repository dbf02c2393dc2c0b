// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/python/arrays.h"
#include "texgen/python/bindings.h"

#include <foamtex/foam.h>

#include <mutex>
#include <utility>

namespace foam::texgen {

/// A foam that several threads of Python may use at the same time.
class SharedFoam {
  public:
    explicit SharedFoam(foamtex::Foam foam) : foam_(std::move(foam)) {}

    /// Returns work(foam). Holds the lock of the foam meanwhile, and does not hold the GIL.
    template <class Work>
    auto use(const Work& work) {
        const pybind11::gil_scoped_release others_may_run;
        const std::scoped_lock lock(mutex_);
        return work(foam_);
    }

  private:
    std::mutex mutex_;
    foamtex::Foam foam_;
};

/// Returns one of the tables of a foam as an array that owns its records.
template <auto member>
pybind11::array table_of(SharedFoam& foam) {
    auto* const kept =
        new foamtex::FoamRecords(foam.use([](const foamtex::Foam& one) { return one.records(); }));
    const pybind11::capsule owner(
        kept, [](void* pointer) { delete static_cast<foamtex::FoamRecords*>(pointer); });
    return view_of(kept->*member, owner);
}

}  // namespace foam::texgen
