#include "texgen/stats/scaling_state.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

namespace {

constexpr int kFewestBubbles = 100;
constexpr double kLargestShare = 0.25;  // of the first bubbles

/// How many records have more bubbles than that; their number never grows.
std::size_t count_above(std::span<const FrameRecord> records, double bubbles) {
    const auto end =
        std::partition_point(records.begin(), records.end(), [&](const FrameRecord& r) {
            return r.foam.bubbles > bubbles;
        });
    return static_cast<std::size_t>(end - records.begin());
}

}  // namespace

std::span<const FrameRecord> measurable(const RunRecord& run) {
    const std::span<const FrameRecord> all(run.frames);
    const std::size_t count = count_above(all, kFewestBubbles - 1);
    return count > 0 ? all.first(count) : all;
}

std::span<const FrameRecord> scaling_state(const RunRecord& run) {
    const std::span<const FrameRecord> records = measurable(run);
    if (records.empty()) {
        return records;
    }
    return records.subspan(count_above(records, kLargestShare * records.front().foam.bubbles));
}

}  // namespace foam::texgen
