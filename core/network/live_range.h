// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/ids.h"

#include <cstddef>
#include <vector>

namespace foam {

/// The ids of the live elements of one kind in increasing order, for a range-based for loop. The
/// vector `live` has one flag per slot, which is true if the element in this slot is live.
/// Precondition: the vector outlives the range.
template <class Id>
class LiveRange {
  public:
    class Iterator {
      public:
        Iterator(const std::vector<bool>& live, std::size_t index) : live_(&live), index_(index) {
            skip_dead();
        }
        Id operator*() const { return id_at<Id>(index_); }
        Iterator& operator++() {
            ++index_;
            skip_dead();
            return *this;
        }
        friend bool operator==(const Iterator& a, const Iterator& b) {
            return a.index_ == b.index_;
        }

      private:
        void skip_dead() {
            while (index_ < live_->size() && !(*live_)[index_]) {
                ++index_;
            }
        }
        const std::vector<bool>* live_;
        std::size_t index_;
    };

    explicit LiveRange(const std::vector<bool>& live) : live_(&live) {}
    Iterator begin() const { return {*live_, 0}; }
    Iterator end() const { return {*live_, live_->size()}; }

    /// Returns the ids as a vector. `count` is their expected number, for which memory is reserved.
    std::vector<Id> ids(std::size_t count) const {
        std::vector<Id> ids;
        ids.reserve(count);
        for (const Id id : *this) {
            ids.push_back(id);
        }
        return ids;
    }

  private:
    const std::vector<bool>* live_;
};

}  // namespace foam
