#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace foam {

/// Items sorted into buckets that are stored one after the other.
template <class Item>
struct Buckets {
    std::vector<Item> items;
    std::vector<std::size_t> ends{0};  // bucket k holds the items from ends[k] to ends[k + 1]

    /// Returns the items of the buckets [first, last).
    std::span<const Item> of(std::size_t first, std::size_t last) const {
        return std::span(items).subspan(ends[first], ends[last] - ends[first]);
    }
};

/// Sorts items into buckets by counting, in two passes. visit(part, put) calls put(bucket, item)
/// for each item of a part; it is called twice per part and must do the same both times. Within a
/// bucket, items are ordered by part, then by call. Threads share the parts; the result is the same
/// for any number of threads.
template <class Item, class Visit>
Buckets<Item> counting_sort(std::size_t buckets,
                            std::size_t parts,
                            int threads,
                            const Visit& visit) {
    // First the number of items that each part has in each bucket, then where its next one goes.
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
