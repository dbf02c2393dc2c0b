// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/ids.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// The inverse of a list of ids: maps an id to its rank, which is the index of the id in the list.
/// If the list contains at least one sixteenth of all ids, the ranks are stored in a table with a
/// slot per id. For a shorter list they are stored in a hash table with linear probing, so that
/// numbering a few bubbles is cheap in a large foam.
template <class Id>
class RankTable {
  public:
    RankTable() = default;

    /// Builds the table of a list of ids. `slots` is the number of all ids, including dead slots.
    /// Precondition: each id of the list is below `slots` and occurs once.
    RankTable(std::span<const Id> list, std::size_t slots) {
        is_direct_ = list.size() * kSparse >= slots;
        const std::size_t size =
            is_direct_ ? slots : std::bit_ceil(kSlotsPerId * std::max<std::size_t>(list.size(), 1));
        shift_ = 32 - std::countr_zero(size);
        entries_.assign(is_direct_ ? 0 : size, Entry{});
        direct_.assign(is_direct_ ? size : 0, -1);
        for (std::size_t k = 0; k < list.size(); ++k) {
            insert(list[k], static_cast<int>(k));
        }
    }

    /// Returns the index of the id in the list; negative if the id is not in it. Precondition: the
    /// id is below the `slots` of the constructor.
    int operator[](Id id) const {
        return is_direct_ ? direct_[index_of(id)] : entries_[slot_of(id)].rank;
    }

  private:
    // A list is stored in a hash table if it contains less than 1 / kSparse of all ids.
    static constexpr std::size_t kSparse = 16;
    static constexpr std::size_t kSlotsPerId = 2;  // smallest number of hash table slots per id

    struct Entry {
        Id id = kNone<Id>;
        int rank = -1;
    };

    void insert(Id id, int rank) {
        if (is_direct_) {
            direct_[index_of(id)] = rank;
        } else {
            entries_[slot_of(id)] = {id, rank};
        }
    }

    // Returns the slot of the id, or the free slot where it would be inserted.
    std::size_t slot_of(Id id) const {
        // Fibonacci hashing multiplies the id by 2^32 divided by the golden ratio.
        constexpr std::uint32_t kGoldenRatio = 0x9E3779B9;
        std::size_t slot = (static_cast<std::uint32_t>(id) * kGoldenRatio) >> shift_;
        while (entries_[slot].id != id && entries_[slot].id != kNone<Id>) {
            slot = (slot + 1) & (entries_.size() - 1);
        }
        return slot;
    }

    bool is_direct_ = true;
    int shift_ = 0;
    std::vector<int> direct_;
    std::vector<Entry> entries_;
};

}  // namespace foam
