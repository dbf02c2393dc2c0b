// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/small_preset.h"
#include "tests/texgen/verify/breathing_loop.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/png.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace foam::texgen {
namespace {

TEST(VerifyReport, ReportsForPersonsAndPrograms) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), frames_to(8));
    std::filesystem::remove(folder.path() / "id.0005.png");
    const Verification found = verify(folder.path() / kManifestName);
    const std::string text = to_text(found);
    EXPECT_NE(text.find("files    23 of 24 match their hash in the manifest"), std::string::npos);
    EXPECT_NE(text.find("FAILED   cannot read '"), std::string::npos);
    const auto report = nlohmann::json::parse(to_json(found));
    EXPECT_EQ(report["status"], "failed");
    EXPECT_EQ(report["sets"][0]["files_same"], 23);
    EXPECT_EQ(report["sets"][0]["problems"].size(), 1U);
    EXPECT_EQ(report["sets"][0]["maps"][0]["name"], "albedo");
    EXPECT_LT(report["sets"][0]["maps"][0]["loop"]["ratio"], 1.1);
    EXPECT_TRUE(report["sets"][0]["maps"][2]["loop"].is_null());  // a frame is missing
}

TEST(VerifyReport, TellsOfClippedSamples) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.image.maps = {"height"};
    preset.maps.height.full = {0.01};
    bake_small(preset, frames_to(2));
    const Verification found = verify(folder.path());
    EXPECT_NE(to_text(found).find("  clipped  height: up to "), std::string::npos);
    const auto report = nlohmann::json::parse(to_json(found));
    EXPECT_GT(report["sets"][0]["maps"][0]["clipped"], 0.5);
}

}  // namespace
}  // namespace foam::texgen
