// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace foam {

/// Items sorted into buckets. The buckets are stored one after the other.
template <class Item>
struct Buckets {
    std::vector<Item> items;
    // For each bucket, the index of its first item in `items`. The last element is the size of
    // `items`.
    std::vector<std::size_t> begins{0};

    /// Returns the items of all buckets in [first, last).
    std::span<const Item> items_of(std::size_t first, std::size_t last) const {
        return std::span(items).subspan(begins[first], begins[last] - begins[first]);
    }
};

/// Returns items sorted into `buckets` buckets, by a parallel counting sort in two passes. The
/// caller divides the items into `parts` parts. Each pass calls visit(part, put) once for each part
/// in [0, parts), and `visit` must call put(bucket, item) for each item of the part. Within a
/// bucket, items are ordered by part, and within a part by the order of the calls of `put`. Up to
/// thread_count(threads) threads process different parts at the same time. The result is the same
/// for any number of threads. Precondition: for each part, `visit` makes the same calls of `put` in
/// the same order in both passes, with bucket < buckets.
template <class Item, class Visit>
Buckets<Item> counting_sort(std::size_t buckets,
                            std::size_t parts,
                            int threads,
                            const Visit& visit) {
    // Both passes use pointers, because std::vector checks indices in hardened builds.
    //
    // The first pass counts the items of each part in each bucket. A prefix sum then replaces each
    // count by an index in `sorted.items`: the index of the first item that the part puts into the
    // bucket.
    std::vector<std::vector<std::size_t>> next(parts);
    parallel_for(parts, 1, threads, [&](std::size_t part, std::size_t) {
        std::vector<std::size_t> counts(buckets);
        visit(part, [to = counts.data()](std::size_t bucket, const Item&) { ++to[bucket]; });
        next[part] = std::move(counts);
    });
    Buckets<Item> sorted;
    sorted.begins.resize(buckets + 1);
    std::size_t end = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        for (std::vector<std::size_t>& positions : next) {
            end += std::exchange(positions[bucket], end);
        }
        sorted.begins[bucket + 1] = end;
    }
    sorted.items.resize(end);
    parallel_for(parts, 1, threads, [&](std::size_t part, std::size_t) {
        visit(part,
              [positions = next[part].data(), items = sorted.items.data()](
                  std::size_t bucket, const Item& item) { items[positions[bucket]++] = item; });
    });
    return sorted;
}

}  // namespace foam
