// SPDX-License-Identifier: Apache-2.0

#include "texgen/json/json_writer.h"
#include "texgen/verify/verify.h"

#include <fmt/format.h>

#include <optional>

namespace foam::texgen {

namespace {

using SeamOf = std::optional<Seam> VerifiedMap::*;

// Returns the ratios of a seam for all maps in which it was checked, for example "albedo 0.930,
// height 0.880".
std::string ratios(const VerifiedSet& found, SeamOf seam) {
    std::string list;
    for (const VerifiedMap& map : found.maps) {
        if (map.*seam) {
            list += fmt::format(
                "{}{} {:.3f}", list.empty() ? "" : ", ", map.name, (map.*seam)->ratio());
        }
    }
    return list;
}

std::string tile_line(const VerifiedSet& found) {
    const std::string list = ratios(found, &VerifiedMap::tile);
    if (list.empty()) {
        return fmt::format(
            "not checked: needs a frame that tiles, has at least {0} x {0} pixels and is unchanged "
            "since the bake",
            kMinTileSize);
    }
    return fmt::format(
        "{}  (step across the border / largest step inside, at most {})", list, kMaxTileRatio);
}

// Returns the reason why no loop of this period was checked.
std::string unchecked_loop(int period) {
    if (period < kMinLoopPeriod) {
        return fmt::format("not checked: needs a loop of at least {} frames", kMinLoopPeriod);
    }
    return fmt::format("not checked: needs frames 1 to {}, unchanged since the bake", period);
}

std::string loop_line(const VerifiedSet& found) {
    const ManifestLoop& loop = found.set.loop;
    if (loop.period == 0) {
        return loop.description;
    }
    const std::string list = ratios(found, &VerifiedMap::loop);
    const std::string measured =
        list.empty() ? unchecked_loop(loop.period)
                     : fmt::format(
                           "{}  (step from last to first frame / largest step between frames, at "
                           "most {:.3g})",
                           list,
                           largest_loop_ratio(loop.period));
    const std::string closing =
        loop.closing_error
            ? fmt::format(
                  "; the last cycle before frame 1 ends {:.1e} mean bubble diameters from "
                  "its start",
                  *loop.closing_error)
            : "";
    return fmt::format("{}\n           {}{}{}",
                       measured,
                       loop.description,
                       loop.cross_faded ? ", cross-faded" : "",
                       closing);
}

// Returns a line for each map with clipped samples.
std::string clipped_lines(const VerifiedSet& found) {
    std::string lines;
    for (const VerifiedMap& map : found.maps) {
        if (map.numbers && map.numbers->clipped > 0.0) {
            lines += fmt::format(
                "  clipped  {}: up to {:.3g} % of the samples of a file; the numbers are from "
                "{:.3g} to {:.3g}\n",
                map.name,
                100.0 * map.numbers->clipped,
                map.numbers->smallest,
                map.numbers->largest);
        }
    }
    return lines;
}

std::string text_of(const VerifiedSet& found) {
    const BakedSet& set = found.set;
    std::string text = fmt::format("{}: seed {}, {} x {}, foamtex {}\n",
                                   set.preset,
                                   set.seed,
                                   set.width,
                                   set.height,
                                   set.version);
    text += fmt::format("  files    {} of {} match their hash in the manifest\n",
                        found.files_same,
                        set.files.size());
    text += "  tile     " + tile_line(found) + "\n";
    text += "  loop     " + loop_line(found) + "\n";
    text += clipped_lines(found);
    for (const std::string& problem : found.problems) {
        text += "  FAILED   " + problem + "\n";
    }
    return text + (found.holds() ? "  all checks passed\n" : "");
}

Json value_of(const std::optional<Seam>& seam) {
    if (!seam) {
        return nullptr;
    }
    return {{"ratio", number_or_null(seam->ratio())},
            {"across", seam->across},
            {"largest_within", seam->largest_within}};
}

Json value_of(const VerifiedMap& map, int period) {
    return {{"name", map.name},
            {"holds", map.holds(period)},
            {"tile", value_of(map.tile)},
            {"tile_frame", map.tile ? Json(map.tile_frame) : Json(nullptr)},
            {"loop", value_of(map.loop)},
            {"clipped", map.numbers ? Json(map.numbers->clipped) : Json(nullptr)}};
}

Json value_of(const VerifiedSet& found) {
    Json maps = Json::array();
    for (const VerifiedMap& map : found.maps) {
        maps.push_back(value_of(map, found.set.loop.period));
    }
    const BakedSet& set = found.set;
    // "called" is a description of the kind for users. The name is part of the format.
    return {{"preset", set.preset},
            {"seed", set.seed},
            {"holds", found.holds()},
            {"complete", set.complete()},
            {"files", set.files.size()},
            {"files_same", found.files_same},
            {"loop",
             {{"kind", set.loop.kind},
              {"called", set.loop.description},
              {"largest_ratio",
               set.loop.period >= kMinLoopPeriod ? Json(largest_loop_ratio(set.loop.period))
                                                 : Json(nullptr)}}},
            {"maps", maps},
            {"problems", found.problems}};
}

}  // namespace

std::string to_text(const Verification& found) {
    std::string text;
    for (const VerifiedSet& set : found.sets) {
        text += text_of(set);
    }
    if (!found.unchecked.empty()) {
        text += fmt::format(
            "not checked, since the folder has newer images of the same preset: {}; --all checks "
            "them\n",
            fmt::join(found.unchecked, ", "));
    }
    return text.empty() ? "the manifest lists no images\n" : text;
}

std::string to_json(const Verification& found) {
    Json sets = Json::array();
    for (const VerifiedSet& set : found.sets) {
        sets.push_back(value_of(set));
    }
    const Json report{{"status", found.holds() ? "holds" : "failed"},
                      {"folder", found.folder.string()},
                      {"largest_tile_ratio", kMaxTileRatio},
                      {"sets", sets},
                      {"unchecked", found.unchecked}};
    return json_text(report) + "\n";
}

}  // namespace foam::texgen
