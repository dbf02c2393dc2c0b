// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace foam::texgen {

namespace {

// Returns the growth of the bubbles with a given number of sides. If the record has no growth for
// this number, the number of bubbles in the result is 0.
SidesGrowth growth_of(const FrameRecord& record, int sides) {
    const auto found = std::find_if(record.growth.begin(),
                                    record.growth.end(),
                                    [&](const SidesGrowth& part) { return part.sides == sides; });
    return found != record.growth.end() ? *found : SidesGrowth{sides, 0, 0.0};
}

std::string sides_row(const RunRecord& run,
                      const FrameRecord& record,
                      const SidesStatistics& part) {
    const SidesGrowth growth = growth_of(record, part.sides);
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n",
                       record.frame,
                       record.time,
                       part.sides,
                       part.bubbles,
                       static_cast<double>(part.bubbles) / record.foam.bubbles,
                       part.mean_area,
                       part.mean_pressure,
                       growth.bubbles,
                       growth.bubbles > 0 ? fmt::format("{}", growth.mean_rate) : "",
                       run.kappa * part.mean_inflow,
                       run.law_rate(part.sides));
}

}  // namespace

std::string frames_csv(const RunRecord& run) {
    std::string csv =
        "frame,time,bubbles,mean_area,energy,second_moment,area_error,angle_error,t1,t2,seconds\n";
    for (const FrameRecord& record : run.frames) {
        fmt::format_to(std::back_inserter(csv),
                       "{},{},{},{},{},{},{},{},{},{},{}\n",
                       record.frame,
                       record.time,
                       record.foam.bubbles,
                       record.foam.mean_area,
                       record.foam.energy,
                       record.foam.second_moment,
                       record.effort.area_error,
                       record.effort.angle_error,
                       record.effort.t1,
                       record.effort.t2,
                       record.effort.seconds);
    }
    return csv;
}

std::string maze_csv(const RunRecord& run) {
    std::string csv;
    for (const FrameRecord& record : run.frames) {
        if (record.maze) {
            csv += csv.empty() ? "frame,time,bubbles,solution,dead_ends,branches\n" : "";
            csv += fmt::format("{},{},{},{},{},{}\n",
                               record.frame,
                               record.time,
                               record.foam.bubbles,
                               record.maze->solution,
                               record.maze->dead_ends,
                               record.maze->branches);
        }
    }
    return csv;
}

std::string sides_csv(const RunRecord& run) {
    std::string csv =
        "frame,time,sides,bubbles,share,mean_area,mean_pressure,"
        "untouched,area_rate,film_rate,law_rate\n";
    for (const FrameRecord& record : run.frames) {
        for (const SidesStatistics& part : record.foam.by_sides) {
            csv += sides_row(run, record, part);
        }
    }
    return csv;
}

}  // namespace foam::texgen
