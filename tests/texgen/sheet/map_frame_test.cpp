// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_frame.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/sheet/sheet_cells.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/exr.h"
#include "texgen/sheet/flipbook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

TEST(MapFrame, JoinsALayerOfExrs) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.output.pattern = (folder.path() / "small.####.exr").string();
    const BakedSet set = baked(preset, {"albedo", "height", "id"});
    write_flipbook(set, folder.path(), {.columns = 3, .gutter = kGutter}, folder.path());
    const Picture frame = read_picture(folder.path() / "small.0004.exr");
    std::size_t compared = 0;
    for (const ChannelGroup& group : frame.groups) {
        const std::string& name = group.names.front();
        const std::size_t dot = name.find('.');
        const Picture sheet =
            read_picture(folder.path() / ("small_sheet_" + name.substr(0, dot) + ".exr"));
        EXPECT_EQ(sheet.metadata.frame_rate, (FrameRate{24, 1}));
        const auto same = std::ranges::find(
            sheet.groups, std::vector{name.substr(dot + 1)}, &ChannelGroup::names);
        ASSERT_NE(same, sheet.groups.end()) << name;
        EXPECT_EQ(same->type, group.type);
        std::visit(
            [&]<class Sample>(const Image<Sample>& pixels) {
                expect_cell(std::get<Image<Sample>>(same->samples), 0, 1, pixels);
            },
            group.samples);
        ++compared;
    }
    EXPECT_EQ(compared, 5U);  // R, G, B of albedo, and one channel of each other map
}

// Another program may have added a layer whose name begins with that of the map.
TEST(MapFrame, KeepsOnlyTheLayerOfTheMap) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "frame.exr";
    const Picture picture{{{{"height.Y"}, SampleType::Float, Image<float>(2, 1, 1)},
                           {{"height.mask.Y"}, SampleType::Float, Image<float>(2, 1, 1)}}};
    write_file(path, encode_exr(picture));
    const Picture frame = read_map_frame({.path = path, .frame = 1, .layered = true}, "height");
    ASSERT_EQ(frame.groups.size(), 1U);
    EXPECT_EQ(frame.groups.front().names.front(), "Y");
}

}  // namespace
}  // namespace foam::texgen
