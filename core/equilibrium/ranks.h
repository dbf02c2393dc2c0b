#pragma once

#include "core/network/ids.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// The index of each id in a list. For a list that holds a good part of all ids it is a table by
/// id; for a shorter one it is a hash table of the list's size, so that numbering a few bubbles is
/// cheap in a large foam.
template <class Id>
class Ranks {
  public:
    Ranks() = default;

    /// Precondition: each id of the list is below `slots` and occurs once.
    Ranks(std::span<const Id> list, std::size_t slots) {
        is_direct_ = list.size() * kSparse >= slots;
        const std::size_t size =
            is_direct_ ? slots : std::bit_ceil(kRoom * std::max<std::size_t>(list.size(), 1));
        shift_ = 32 - std::countr_zero(size);
        entries_.assign(is_direct_ ? 0 : size, Entry{});
        direct_.assign(is_direct_ ? size : 0, -1);
        for (std::size_t k = 0; k < list.size(); ++k) {
            insert(list[k], static_cast<int>(k));
        }
    }

    /// Returns the index of the id, negative if it is not in the list.
    int operator[](Id id) const {
        return is_direct_ ? direct_[index_of(id)] : entries_[slot_of(id)].rank;
    }

  private:
    static constexpr std::size_t kSparse =
        16;  // a list is short if it has fewer than one id in so many
    static constexpr std::size_t kRoom = 2;  // slots of the hash table per id, at least

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

    // Returns the slot of the id, or the free one that it would take.
    std::size_t slot_of(Id id) const {
        constexpr std::uint32_t kGoldenRatio = 0x9E3779B9;  // of 2^32: Fibonacci hashing
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
