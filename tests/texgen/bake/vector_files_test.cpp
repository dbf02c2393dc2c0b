// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/vector_files.h"

#include "core/files/file_io.h"
#include "core/foam/honeycomb.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/manifest/set_choice.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

BakedSet only_set(const std::filesystem::path& folder) {
    return newest_set(read_manifest(folder), {}, folder);
}

std::string rejection_of(const Preset& preset) {
    try {
        check_bake(preset, {.frames = {1}});
        return {};
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(VectorFiles, ADrawingIsWrittenAndRecorded) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / "{map}.##.svg");
    bake_recorded(preset, {.frames = {1, 2}}, {});
    EXPECT_EQ(folder.files(), (Names{"foam.01.svg", "foam.02.svg", "manifest.json"}));
    const BakedSet set = only_set(folder.path());
    EXPECT_TRUE(set.complete());
    ASSERT_EQ(set.maps.size(), 1U);
    EXPECT_EQ(set.maps[0].name, "foam");
    EXPECT_EQ(set.maps[0].vector_format, "SVG");
    EXPECT_EQ(set.maps[0].unit, "millimeters");
    const std::string content = content_of(folder.path() / "foam.01.svg");
    EXPECT_EQ(set.files[0].pixels, text_hash(content));
    EXPECT_EQ(set.files[0].bytes, content.size());
}

TEST(VectorFiles, TablesAreThreeFiles) {
    const TemporaryFolder folder;
    bake_recorded(small_preset(folder.path() / "x.csv"), {.frames = {1}}, {});
    EXPECT_EQ(folder.files(),
              (Names{"manifest.json", "x_bubbles.csv", "x_films.csv", "x_junctions.csv"}));
    const TemporaryFolder other;
    bake_recorded(small_preset(other.path() / "x.####.json"), {.frames = {3}}, {});
    EXPECT_EQ(other.files(), (Names{"manifest.json", "x.0003.json"}));
}

// --resume keeps unchanged files, and writes damaged files again. verify finds damaged files.
TEST(VectorFiles, DamagedFilesAreFoundAndWrittenAgain) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / "x.##.dxf");
    bake_recorded(preset, {.frames = {1, 2}}, {});
    EXPECT_TRUE(verify(folder.path()).holds());
    const std::filesystem::path damaged = folder.path() / "x.02.dxf";
    std::string content = content_of(damaged);
    const std::string original = content;
    content[content.size() / 2] = '?';
    std::ofstream(damaged, std::ios::binary) << content;
    EXPECT_FALSE(verify(folder.path()).holds());
    const BakeSummary summary =
        bake_recorded(preset, {.frames = {1, 2}}, {}, {.resume = Resume::Yes});
    EXPECT_EQ(summary.kept, 1);
    EXPECT_EQ(content_of(damaged), original);
    EXPECT_TRUE(verify(folder.path()).holds());
}

TEST(VectorFiles, BytesDoNotDependOnThreads) {
    for (const std::string suffix : {".svg", ".stl", ".glb"}) {
        const TemporaryFolder one;
        const TemporaryFolder two;
        const std::string pattern = "x.#" + suffix;
        bake_recorded(small_preset(one.path() / pattern), {.frames = {1, 2, 3}, .threads = 1}, {});
        bake_recorded(small_preset(two.path() / pattern), {.frames = {1, 2, 3}, .threads = 3}, {});
        for (const char* const number : {"1", "2", "3"}) {
            const std::string name = std::string("x.000") + number + suffix;
            EXPECT_EQ(content_of(one.path() / name), content_of(two.path() / name)) << name;
            EXPECT_FALSE(content_of(one.path() / name).empty()) << name;
        }
    }
}

TEST(VectorFiles, AMeshIsWrittenAndRecorded) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "{map}.glb");
    bake_recorded(preset, {.frames = {1}}, {});
    EXPECT_EQ(folder.files(), (Names{"manifest.json", "relief.glb"}));
    EXPECT_EQ(only_set(folder.path()).maps[0].unit, "meters");
    EXPECT_EQ(only_set(folder.path()).maps[0].meaning, "the relief as a closed mesh");
    preset.mesh.base_mm = 0.0;
    EXPECT_NE(rejection_of(preset).find("mesh.base_mm = 0"), std::string::npos);
}

TEST(VectorFiles, PackingsSheetsAndCrossFadesAreRejected) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "x.svg");
    EXPECT_EQ(rejection_of(preset), "");
    preset.output.pack = {"ORM=occlusion,roughness,metallic"};
    EXPECT_EQ(rejection_of(preset),
              "SVG files have no channels, so output.pack (--pack) must be empty");
    preset = small_preset(folder.path() / "x.pdf");
    preset.output.sheets = SheetKind::Grid;
    EXPECT_EQ(rejection_of(preset), "PDF files have no pixels, so output.sheets must be \"none\"");
    preset = small_preset(folder.path() / "x.json");
    preset.loop.kind = LoopKind::Flow;
    EXPECT_NE(rejection_of(preset).find("set loop.kind to another loop"), std::string::npos);
}

TEST(VectorFiles, TheManifestIsNotOverwritten) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / "manifest.json");
    EXPECT_THROW(bake_recorded(preset, {.frames = {1}}, {}), std::invalid_argument);
    EXPECT_TRUE(folder.files().empty());
}

// The function for programs that have a frame, but no file name.
TEST(VectorFiles, AFrameBecomesSvg) {
    SimulatedFrame shown;
    Foam foam = honeycomb(4, 4);
    foam.domain.height = foam.domain.width;
    shown.frame = std::make_shared<const Frame>(snapshot(foam, 5));
    shown.record = std::make_shared<const FoamRecord>();
    const std::string text = to_svg(shown, small_preset("x.png"));
    EXPECT_NE(text.find("<title>small, frame 5</title>"), std::string::npos);
    EXPECT_NE(text.find("id=\"bubble-15\""), std::string::npos);
    shown.fading_in = shown;
    EXPECT_THROW(to_svg(shown, small_preset("x.png")), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
