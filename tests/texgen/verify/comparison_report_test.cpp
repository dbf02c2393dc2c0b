// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/comparison_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

ComparedImage different() {
    ComparedImage image{.pair = {"a.png", "b.png"}, .map = "normal"};
    image.verdict = Verdict::Warning;
    image.found = {.verdict = Verdict::Warning,
                   .largest = 0.25,
                   .mean = 0.125,
                   .rms = 0.15,
                   .percentile = 0.2,
                   .warnings = 3,
                   .failures = 0,
                   .channel = "R",
                   .x = 4,
                   .y = 5,
                   .pixels = 100,
                   .warning_pixels = 2,
                   .failure_pixels = 0,
                   .angle = 1.5,
                   .angle_x = 6,
                   .angle_y = 7,
                   .reasons = {"2 of 100 pixels above 0.1", "rms 0.15 above 0.1"}};
    return image;
}

ComparedImage absent(Presence presence, const std::string& map, int frame) {
    return {.pair = {"g/a.png", "n/a.png", presence, map, frame},
            .map = map,
            .verdict = Verdict::Failure};
}

TEST(ComparisonReport, ALineGivesTheReasonsAndTheDifferences) {
    EXPECT_EQ(to_line(different()),
              "b.png: warning (2 of 100 pixels above 0.1, rms 0.15 above 0.1), largest difference "
              "0.25 in R at 4,5, mean 0.125, rms 0.15, percentile 99.9 = 0.2, largest angle 1.5 "
              "degrees at 6,7");
    ComparedImage layer = different();
    layer.layer = "normal";
    EXPECT_EQ(to_line(layer).rfind("b.png: normal: warning", 0), 0U);
    EXPECT_EQ(to_line({.pair = {"a.png", "b.png"}, .map = ""}), "b.png: same");
}

TEST(ComparisonReport, AbsentAndUnreadableImagesAreNamed) {
    EXPECT_EQ(to_line(absent(Presence::OnlyA, "", 1)), "n/a.png: missing, but 'g/a.png' exists");
    EXPECT_EQ(to_line(absent(Presence::OnlyB, "", 1)),
              "n/a.png: extra, because 'g/a.png' does not exist");
    EXPECT_EQ(to_line({.pair = {"a.png", "b.png"},
                       .map = "",
                       .verdict = Verdict::Unreadable,
                       .error = "cannot read 'b.png': no"}),
              "b.png: unreadable, cannot read 'b.png': no");
}

TEST(ComparisonReport, TheSummaryNamesAbsentFramesByMap) {
    const std::vector<ComparedImage> images = {absent(Presence::OnlyA, "normal", 5),
                                               absent(Presence::OnlyA, "normal", 4),
                                               absent(Presence::OnlyB, "", 9),
                                               different(),
                                               {.pair = {"a.png", "b.png"}, .map = ""}};
    EXPECT_EQ(summary_of(images),
              "frames 9 exist only in B\n"
              "normal: frames 4-5 exist only in A\n"
              "5 images: 1 same, 1 warning, 2 missing, 1 extra\n");
}

TEST(ComparisonReport, JsonHasTheSameMembersForEveryImage) {
    const std::vector<ComparedImage> images = {different(), absent(Presence::OnlyA, "", 4)};
    const nlohmann::json report = nlohmann::json::parse(to_json(images));
    EXPECT_EQ(report["status"], "failure");
    const nlohmann::json& found = report["images"][0];
    EXPECT_EQ(found["verdict"], "warning");
    EXPECT_EQ(found["map"], "normal");
    EXPECT_EQ(found["rms"], 0.15);
    EXPECT_EQ(found["percentile_99_9"], 0.2);
    EXPECT_EQ(found["angle"], 1.5);
    EXPECT_EQ(found["warning_pixels"], 2);
    EXPECT_EQ(found["pixels"], 100);
    EXPECT_EQ(found["warnings"], 3);
    EXPECT_EQ(found["reasons"].size(), 2U);
    EXPECT_TRUE(found["frame"].is_null());
    const nlohmann::json& missing = report["images"][1];
    EXPECT_EQ(missing["verdict"], "missing");
    EXPECT_EQ(missing["frame"], 4);
    EXPECT_TRUE(missing["map"].is_null());
    EXPECT_TRUE(missing["angle"].is_null());
    EXPECT_EQ(missing.size(), found.size());
}

// A file name of Linux is a sequence of bytes.
TEST(ComparisonReport, JsonIsValidForAnyFileName) {
    ComparedImage image{.pair = {"a\xff.png", "b.png"}, .map = ""};
    EXPECT_TRUE(nlohmann::json::accept(to_json(std::span(&image, 1))));
}

}  // namespace
}  // namespace foam::texgen
