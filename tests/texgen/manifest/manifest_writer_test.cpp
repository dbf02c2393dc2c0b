// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/manifest/small_set.h"
#include "texgen/manifest/manifest_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ManifestWriter, RoundTrips) {
    const Manifest manifest = small_manifest();
    EXPECT_EQ(parse_manifest(to_json(manifest), "m.json"), manifest);
    EXPECT_EQ(parse_manifest(to_json({}), "m.json"), Manifest{});
}

TEST(ManifestWriter, IsJsonWithALineForEachFile) {
    const std::string text = to_json(small_manifest());
    const auto tree = nlohmann::json::parse(text);
    EXPECT_EQ(tree["format"], "foamtex-manifest");
    EXPECT_EQ(tree["sets"][0]["complete"], false);
    EXPECT_EQ(tree["sets"][1]["complete"], false);
    EXPECT_EQ(tree["sets"][0]["failure"], "the disk is full");
    EXPECT_EQ(tree["sets"][0]["foam"][0]["strain"], 0.25);
    EXPECT_EQ(tree["sets"][0]["foam"][0]["energy"], 75.5);
    EXPECT_EQ(tree["sets"][0]["foam"][0]["stress"], (std::vector<double>{1.0, -0.125, 0.75}));
    EXPECT_FALSE(tree["sets"][0]["foam"][1].contains("stress"));
    EXPECT_EQ(tree["sets"][0]["seconds"]["drawing"], 1.0);  // sum over two frames
    EXPECT_NE(
        text.find("\n        {\"path\":\"a_height.3.png\",\"maps\":[\"height\"],\"frame\":3,"),
        std::string::npos);
}

TEST(ManifestWriter, ANumberThatIsNotFiniteIsNull) {
    Manifest manifest = small_manifest();
    manifest.sets[0].frame_statistics[0].area_error = std::numeric_limits<double>::infinity();
    const Manifest read = parse_manifest(to_json(manifest), "m.json");
    EXPECT_TRUE(std::isnan(read.sets[0].frame_statistics[0].area_error));
}

}  // namespace
}  // namespace foam::texgen
