// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_remarks.h"

#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(PresetRemarks, TheDensityIsStretchedOverTheTorusOrTheOutline) {
    Preset preset;
    preset.image.width = 300;
    preset.image.height = 100;
    EXPECT_TRUE(density_domain(preset).is_torus);
    EXPECT_DOUBLE_EQ(density_domain(preset).aspect, 3.0);
    preset.shape.kind = FoamKind::Patch;
    preset.shape.outline = "rectangle";
    preset.shape.outline_aspect = 2.0;
    EXPECT_FALSE(density_domain(preset).is_torus);
    EXPECT_DOUBLE_EQ(density_domain(preset).aspect, 2.0);
}

TEST(PresetRemarks, AreOnKeysWithoutEffectAndOnThePicture) {
    Preset preset;
    EXPECT_TRUE(remarks_on(preset, {}).empty());
    preset.image.width = 2 * preset.image.height;
    preset.density.source = {
        "x.png", {"x.png", std::make_shared<const SourcePicture>(SourcePicture{{1, 1, 4}}), ""}};
    EXPECT_EQ(remarks_on(preset, {}).size(), 1U);
}

TEST(PresetRemarks, AreOnKeysThatNoDrawnMapUses) {
    Preset preset;
    preset.image.maps = {"height", "area"};
    std::vector<Assignment> assignments;
    for (const char* const argument : {"lit.elevation=30",
                                       "lit.elevation=31",
                                       "relief.width=0.3",
                                       "area.full=2",
                                       "albedo.grain=0.1",
                                       "foam.seed=2"}) {
        assignments.push_back(read_set_argument(argument));
    }
    assign(preset, assignments);
    using Lines = std::vector<std::string>;
    EXPECT_EQ(keys_without_maps(preset, assignments),
              (Lines{"lit.elevation has no effect on the drawn maps height, area",
                     "albedo.grain has no effect on the drawn maps height, area"}));
    preset.image.maps = {"lit"};
    EXPECT_EQ(keys_without_maps(preset, assignments),
              Lines{"area.full has no effect on the drawn map lit"});
}

TEST(PresetRemarks, AreOnKeysOfColorsThatAreNotDrawn) {
    Preset preset;
    const std::vector<Assignment> assignments{read_set_argument("albedo.colormap=magma"),
                                              read_set_argument("albedo.film_width=3"),
                                              read_set_argument("thin_film.gravity=2")};
    assign(preset, assignments);
    using Lines = std::vector<std::string>;
    preset.image.maps = {"lit"};
    EXPECT_EQ(keys_without_maps(preset, assignments),
              Lines{"thin_film.gravity has no effect on the drawn map lit with lit.colors = "
                    "\"albedo\""});
    preset.maps.lit.colors = LitColors::ThinFilm;
    EXPECT_EQ(keys_without_maps(preset, assignments),
              Lines{"albedo.colormap has no effect on the drawn map lit with lit.colors = "
                    "\"thin_film\""});
    preset.image.maps = {"roughness"};
    EXPECT_EQ(keys_without_maps(preset, assignments),
              (Lines{"albedo.colormap has no effect on the drawn map roughness",
                     "thin_film.gravity has no effect on the drawn map roughness"}));
}

}  // namespace
}  // namespace foam::texgen
