#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Things in bins, one bin after the other.
template <class Thing>
struct Bins {
    std::vector<Thing> things;
    std::vector<std::size_t> ends{0};  // those of bin k: from ends[k] to ends[k + 1]

    /// Of the bins [first, last).
    std::span<const Thing> of(std::size_t first, std::size_t last) const {
        return std::span(things).subspan(ends[first], ends[last] - ends[first]);
    }
};

/// Puts things into bins: visit(part, put) calls put(bin, thing) for those of a part, the same ones
/// whenever it is asked. Within a bin they lie in the order of the parts, and then of their calls;
/// so they do for any number of threads, which share the parts.
template <class Thing, class Visit>
Bins<Thing> into_bins(std::size_t bins, std::size_t parts, int threads, const Visit& visit) {
    const auto for_parts = [&](const auto& body) {
        parallel_for(static_cast<int>(parts), threads, [&](int part) {
            body(static_cast<std::size_t>(part));
        });
    };
    // How many a part has in each bin, then where its next one goes.
    std::vector<std::vector<std::size_t>> next(parts);
    for_parts([&](std::size_t part) {
        std::vector<std::size_t> counts(bins);
        visit(part, [&](std::size_t bin, const Thing&) { ++counts[bin]; });
        next[part] = std::move(counts);
    });
    Bins<Thing> all;
    all.ends.resize(bins + 1);
    std::size_t end = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        for (std::vector<std::size_t>& places : next) {
            end += std::exchange(places[bin], end);
        }
        all.ends[bin + 1] = end;
    }
    all.things.resize(end);
    for_parts([&](std::size_t part) {
        visit(part,
              [&](std::size_t bin, const Thing& thing) { all.things[next[part][bin]++] = thing; });
    });
    return all;
}

}  // namespace foam::texgen
