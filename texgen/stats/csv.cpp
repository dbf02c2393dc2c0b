// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/csv.h"

#include "core/library/foam_records.h"

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

std::string stress_csv(const RunRecord& run) {
    std::string csv =
        "frame,time,strain,energy,stress_xx,stress_xy,stress_yy,normal_stress_difference,"
        "shear_modulus\n";
    for (const FrameRecord& record : run.frames) {
        const Mat2& stress = record.effort.stress;
        fmt::format_to(std::back_inserter(csv),
                       "{},{},{},{},{},{},{},{},{}\n",
                       record.frame,
                       record.time,
                       record.effort.strain,
                       record.effort.energy,
                       stress(0, 0),
                       stress(0, 1),
                       stress(1, 1),
                       stress(0, 0) - stress(1, 1),
                       record.shear_modulus ? fmt::format("{}", *record.shear_modulus) : "");
    }
    return csv;
}

std::string events_csv(const RunRecord& run) {
    std::string csv = "frame,time,kind,x,y,bubbles\n";
    for (const FrameRecord& record : run.frames) {
        for (const TopologyEvent& event : record.effort.events) {
            fmt::format_to(std::back_inserter(csv),
                           "{},{},{},{},{},{}\n",
                           record.frame,
                           event.time,
                           name_of(event.kind),
                           event.position.x(),
                           event.position.y(),
                           fmt::join(event.bubbles, " "));
        }
    }
    return csv;
}

std::string bubbles_csv(const RunRecord& run) {
    std::string csv =
        "frame,identity,x,y,sides,area,target_area,pressure,perimeter,elongation,orientation\n";
    if (!run.last_frame) {
        return csv;
    }
    for (const foamtex::Bubble& bubble : bubble_records(*run.last_frame)) {
        fmt::format_to(std::back_inserter(csv),
                       "{},{},{},{},{},{},{},{},{},{},{}\n",
                       run.last_frame->number,
                       bubble.identity,
                       bubble.x,
                       bubble.y,
                       bubble.sides,
                       bubble.area,
                       bubble.target_area,
                       bubble.pressure,
                       bubble.perimeter,
                       bubble.elongation,
                       bubble.orientation);
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
