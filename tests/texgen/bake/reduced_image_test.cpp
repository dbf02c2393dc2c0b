// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/reduced_image.h"

#include <gtest/gtest.h>

namespace foam::texgen {

namespace {

Preset preset_of_size(int width, int height) {
    Preset preset;
    preset.image.width = width;
    preset.image.height = height;
    return preset;
}

TEST(ReducedImage, KeepsTheAspectRatioAndIsNeverEnlarged) {
    const ReducedImage wide = reduced_image(preset_of_size(1024, 512), 256);
    EXPECT_EQ(wide.width, 256);
    EXPECT_EQ(wide.height, 128);
    EXPECT_EQ(wide.reduction, 4.0);
    const ReducedImage small = reduced_image(preset_of_size(64, 64), 256);
    EXPECT_EQ(small.width, 64);
    EXPECT_EQ(small.reduction, 1.0);
    const ReducedImage odd = reduced_image(preset_of_size(1000, 999), 256);
    EXPECT_EQ(odd.width, 1000);
    EXPECT_EQ(odd.height, 999);
}

TEST(ReducedImage, ReducesLengthsInPixels) {
    Preset preset = preset_of_size(1024, 1024);
    preset.maps.albedo.film_width = 8.0;
    preset.maps.albedo.film_unit = WidthUnit::Pixels;
    preset.maps.distance.unit = DistanceUnit::Pixels;
    preset.maps.distance.full.value = 64.0;
    const ReducedImage reduced = reduced_image(preset, 256);
    EXPECT_EQ(reduced.options.albedo.film_width, 2.0);
    EXPECT_EQ(reduced.options.distance.full.value, 16.0);
}

TEST(ReducedImage, KeepsLengthsInFoamUnitsAndDiameters) {
    Preset preset = preset_of_size(1024, 1024);
    preset.maps.albedo.film_width = 0.1;
    preset.maps.albedo.film_unit = WidthUnit::Diameters;
    preset.maps.distance.unit = DistanceUnit::Foam;
    preset.maps.distance.full.value = 0.5;
    const ReducedImage reduced = reduced_image(preset, 256);
    EXPECT_EQ(reduced.options.albedo.film_width, 0.1);
    EXPECT_EQ(reduced.options.distance.full.value, 0.5);
}

}  // namespace

}  // namespace foam::texgen
