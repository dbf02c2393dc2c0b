// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/comparison_report.h"

#include "texgen/bake/frame_range.h"
#include "texgen/json/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the value of a verdict in JSON. Programs read these values, so they must not change.
const char* json_value_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::Same:
            return "same";
        case Verdict::Warning:
            return "warning";
        case Verdict::Failure:
            return "failure";
        case Verdict::DifferentLayout:
            return "other size or channels";
        default:
            return "unreadable";
    }
}

// Returns the value of the JSON member "verdict" of a compared image.
const char* json_value_of(const ComparedImage& image) {
    switch (image.pair.presence) {
        case Presence::OnlyA:
            return "missing";
        case Presence::OnlyB:
            return "extra";
        default:
            return json_value_of(image.verdict);
    }
}

const char* text_of(const ComparedImage& image) {
    return image.verdict == Verdict::DifferentLayout ? "different size or channels"
                                                     : json_value_of(image);
}

// Returns the differences in words, such as "largest difference 0.2 in R at 3,4, mean 0.01, ...".
std::string differences_of(const Comparison& found) {
    std::string text = fmt::format(
        "largest difference {:.6g} in {} at {},{}, mean {:.3g}, rms {:.3g}, percentile {} = {:.3g}",
        found.largest,
        found.channel,
        found.x,
        found.y,
        found.mean,
        found.rms,
        kReportedPercentile,
        found.percentile);
    if (found.angle) {
        text += fmt::format(
            ", largest angle {:.4g} degrees at {},{}", *found.angle, found.angle_x, found.angle_y);
    }
    return text;
}

// Returns the results of the comparison of pixels, as members of the JSON object of an image.
Json numbers_of(const Comparison& found) {
    return {{"largest", number_or_null(found.largest)},
            {"mean", number_or_null(found.mean)},
            {"channel", found.channel},
            {"x", found.x},
            {"y", found.y},
            {"warnings", found.warnings},
            {"failures", found.failures},
            {"rms", number_or_null(found.rms)},
            {"percentile_99_9", number_or_null(found.percentile)},
            {"angle", number_or_null(found.angle)},
            {"angle_x", found.angle_x},
            {"angle_y", found.angle_y},
            {"pixels", found.pixels},
            {"warning_pixels", found.warning_pixels},
            {"failure_pixels", found.failure_pixels},
            {"reasons", found.reasons}};
}

Json text_or_null(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json object_of(const ComparedImage& image) {
    Json json{{"a", image.pair.a.string()},
              {"b", image.pair.b.string()},
              {"verdict", json_value_of(image)},
              {"map", text_or_null(image.map)},
              {"layer", text_or_null(image.layer)},
              {"frame", image.pair.frame ? Json(*image.pair.frame) : Json(nullptr)}};
    json.update(numbers_of(image.found));
    json["error"] = text_or_null(image.error);
    return json;
}

// Returns lines that list the frames that exist only in the first input, A, or only in the second
// input, B. There is one line for each map and input.
std::string lines_of_absent_frames(std::span<const ComparedImage> images) {
    std::map<std::pair<std::string, Presence>, std::vector<int>> frames;
    for (const ComparedImage& image : images) {
        if (image.pair.presence != Presence::Both && image.pair.frame) {
            frames[{image.map, image.pair.presence}].push_back(*image.pair.frame);
        }
    }
    std::string lines;
    for (auto& [key, numbers] : frames) {
        std::ranges::sort(numbers);
        lines += fmt::format("{}{}frames {} exist only in {}\n",
                             key.first,
                             key.first.empty() ? "" : ": ",
                             format_frame_range(numbers),
                             key.second == Presence::OnlyA ? "A" : "B");
    }
    return lines;
}

}  // namespace

std::string to_line(const ComparedImage& image) {
    std::string line = fmt::format("{}: {}{}{}",
                                   image.pair.b.string(),
                                   image.layer,
                                   image.layer.empty() ? "" : ": ",
                                   text_of(image));
    if (image.pair.presence == Presence::OnlyA) {
        return line + fmt::format(", but '{}' exists", image.pair.a.string());
    }
    if (image.pair.presence == Presence::OnlyB) {
        return line + fmt::format(", because '{}' does not exist", image.pair.a.string());
    }
    if (image.verdict == Verdict::Unreadable) {
        return line + ", " + image.error;
    }
    const std::string reasons = fmt::format("{}", fmt::join(image.found.reasons, ", "));
    line += reasons.empty() ? "" : " (" + reasons + ")";
    return line + (image.found.largest > 0.0 ? ", " + differences_of(image.found) : "");
}

std::string summary_of(std::span<const ComparedImage> images) {
    constexpr std::array<std::string_view, 7> kResults = {
        "same",
        "warning",
        "failure",
        "different size or channels",
        "missing",
        "extra",
        "unreadable",
    };
    std::map<std::string_view, int> counts;
    for (const ComparedImage& image : images) {
        ++counts[text_of(image)];
    }
    std::string list;
    for (const std::string_view result : kResults) {
        if (counts[result] > 0) {
            list += fmt::format("{}{} {}", list.empty() ? "" : ", ", counts[result], result);
        }
    }
    return fmt::format("{}{} images: {}\n", lines_of_absent_frames(images), images.size(), list);
}

std::string to_json(std::span<const ComparedImage> images) {
    Json list = Json::array();
    for (const ComparedImage& image : images) {
        list.push_back(object_of(image));
    }
    const Json report{{"status", json_value_of(worst_verdict(images))},
                      {"images", std::move(list)}};
    // A file name need not be UTF-8, but JSON must be; json_text replaces invalid bytes.
    return json_text(report) + "\n";
}

}  // namespace foam::texgen
