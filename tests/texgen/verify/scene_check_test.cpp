// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/scene_check.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>

#include <span>
#include <string>

namespace foam::texgen {
namespace {

TEST(SceneCheck, FindsMissingAndChangedFiles) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "{map}.####.png");
    preset.image.maps = {"albedo"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    for (const std::string name : {"a.usda", "b.usda"}) {
        write_file(folder.path() / name, std::as_bytes(std::span(name)));
        update_manifest(folder.path(), [&](Manifest& manifest) {
            add_scenes(manifest,
                       manifest.sets.back().parameters,
                       {{name, "usda", name.size(), text_hash(name)}});
        });
    }
    EXPECT_TRUE(verify(folder.path()).holds());
    write_file(folder.path() / "a.usda", {});
    std::filesystem::remove(folder.path() / "b.usda");
    const Verification found = verify(folder.path());
    EXPECT_FALSE(found.holds());
    ASSERT_EQ(found.sets.front().problems.size(), 2U);
    EXPECT_EQ(found.sets.front().problems[0],
              "a.usda: the content differs from the written content (its hash differs from the "
              "hash in the manifest)");
    EXPECT_NE(found.sets.front().problems[1].find("b.usda': No such file"), std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
