#include "tests/texgen/pictures.h"
#include "tests/texgen/small_preset.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/png.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

Preset small_loop(const std::filesystem::path& folder) {
    Preset preset = small_preset(folder / "{map}.####.png");
    preset.image.maps = {"albedo", "height", "id"};
    preset.frames.count = 8;
    preset.loop.kind = LoopKind::Breathe;
    return preset;
}

void bake_small(const Preset& preset, const std::vector<int>& frames) {
    bake_recorded(preset, {.frames = frames, .threads = 1}, {});
}

TEST(VerifyReport, ReportsForPersonsAndPrograms) {
    const TemporaryFolder folder;
    bake_small(small_loop(folder.path()), frames_to(8));
    std::filesystem::remove(folder.path() / "id.0005.png");
    const Verification found = verify(folder.path() / kManifestName);
    const std::string text = to_text(found);
    EXPECT_NE(text.find("files    23 of 24 have the pixels that were baked"), std::string::npos);
    EXPECT_NE(text.find("FAILED   cannot read '"), std::string::npos);
    const auto report = nlohmann::json::parse(to_json(found));
    EXPECT_EQ(report["status"], "failed");
    EXPECT_EQ(report["sets"][0]["files_same"], 23);
    EXPECT_EQ(report["sets"][0]["problems"].size(), 1U);
    EXPECT_EQ(report["sets"][0]["maps"][0]["name"], "albedo");
    EXPECT_LT(report["sets"][0]["maps"][0]["loop"]["ratio"], 1.1);
    EXPECT_TRUE(report["sets"][0]["maps"][2]["loop"].is_null());  // a frame lacks
}

}  // namespace
}  // namespace foam::texgen
