// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace foam {

/// Items sorted into buckets, which are stored one after the other.
template <class Item>
struct Buckets {
    std::vector<Item> items;
    std::vector<std::size_t> ends{0};  // bucket k is items[ends[k]] to items[ends[k + 1] - 1]

    /// Returns the items of the buckets [first, last).
    std::span<const Item> of(std::size_t first, std::size_t last) const {
        return std::span(items).subspan(ends[first], ends[last] - ends[first]);
    }
};

/// Sorts items into buckets by a parallel counting sort, in two passes. Each pass calls visit(part,
/// put) for each part in [0, parts), which must call put(bucket, item) for each item of the part.
/// Within a bucket, items are ordered by part, then by call. The parts are distributed to up to
/// thread_count(threads) threads; the result is the same for any number. Precondition: both calls
/// of `visit` for a part make the same calls of `put`, with bucket < buckets.
template <class Item, class Visit>
Buckets<Item> counting_sort(std::size_t buckets,
                            std::size_t parts,
                            int threads,
                            const Visit& visit) {
    // The first pass counts the items of each part in each bucket. A prefix sum then replaces each
    // count by the position of the first item of the part in the bucket.
    std::vector<std::vector<std::size_t>> next(parts);
    parallel_for(parts, 1, threads, [&](std::size_t part, std::size_t) {
        std::vector<std::size_t> counts(buckets);
        visit(part, [&](std::size_t bucket, const Item&) { ++counts[bucket]; });
        next[part] = std::move(counts);
    });
    Buckets<Item> sorted;
    sorted.ends.resize(buckets + 1);
    std::size_t end = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        for (std::vector<std::size_t>& positions : next) {
            end += std::exchange(positions[bucket], end);
        }
        sorted.ends[bucket + 1] = end;
    }
    sorted.items.resize(end);
    parallel_for(parts, 1, threads, [&](std::size_t part, std::size_t) {
        visit(part, [&](std::size_t bucket, const Item& item) {
            sorted.items[next[part][bucket]++] = item;
        });
    });
    return sorted;
}

}  // namespace foam
