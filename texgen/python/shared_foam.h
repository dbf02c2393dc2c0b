// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/python/arrays.h"
#include "texgen/python/bindings.h"

#include <foamtex/foam.h>

#include <memory>
#include <mutex>
#include <utility>

namespace foam::texgen {

/// A foam that several threads of Python may use at the same time. A thread that waits for the foam
/// does not hold the GIL.
class SharedFoam {
  public:
    explicit SharedFoam(foamtex::Foam foam) : foam_(std::move(foam)) {}

    /// Returns work(foam). The work cannot change the foam.
    template <class Work>
    auto use(const Work& work) {
        const pybind11::gil_scoped_release others_may_run;
        const std::scoped_lock lock(mutex_);
        return work(std::as_const(foam_));
    }

    /// Returns work(foam). The work may change the foam.
    template <class Work>
    auto change(const Work& work) {
        const pybind11::gil_scoped_release others_may_run;
        const std::scoped_lock lock(mutex_);
        records_.reset();
        return work(foam_);
    }

    /// Returns the bubbles, films and junctions. They are computed once for each state of the foam.
    std::shared_ptr<const foamtex::FoamRecords> records() {
        const pybind11::gil_scoped_release others_may_run;
        const std::scoped_lock lock(mutex_);
        if (!records_) {
            records_ = std::make_shared<const foamtex::FoamRecords>(foam_.records());
        }
        return records_;
    }

  private:
    std::mutex mutex_;
    foamtex::Foam foam_;
    std::shared_ptr<const foamtex::FoamRecords> records_;  // of the present state, or null
};

/// Returns a table of a foam as a read-only array that keeps the table alive. The template argument
/// `member` selects the bubbles, the films or the junctions.
template <auto member>
pybind11::array table_of(SharedFoam& foam) {
    using Records = std::shared_ptr<const foamtex::FoamRecords>;
    auto* const kept = new Records(foam.records());
    const pybind11::capsule owner(kept,
                                  [](void* pointer) { delete static_cast<Records*>(pointer); });
    return view_of(kept->get()->*member, owner);
}

}  // namespace foam::texgen
