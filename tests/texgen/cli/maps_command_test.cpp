// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/json/json_writer.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(MapsCommand, ListsEveryMap) {
    const Outcome list = run_program("maps");
    EXPECT_EQ(list.code, 0);
    EXPECT_EQ(static_cast<std::size_t>(std::count(list.out.begin(), list.out.end(), '\n')),
              all_maps().size());
    for (const Map& map : all_maps()) {
        EXPECT_NE(list.out.find(std::string(map.name) + " "), std::string::npos);
        EXPECT_NE(list.out.find(map.meaning), std::string::npos);
    }
    EXPECT_EQ(run_program("maps --markdown").out, describe_maps_in_markdown());
}

TEST(MapsCommand, ListsOneMap) {
    const Outcome one = run_program("maps albedo");
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_TRUE(one.out.starts_with("albedo  R G B ")) << one.out;
    EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 1);
    const Json maps = Json::parse(run_program("maps normal --json").out)["maps"];
    ASSERT_EQ(maps.size(), 1U);
    EXPECT_EQ(maps[0]["name"], "normal");
    EXPECT_EQ(run_program("maps albedo --markdown").code, static_cast<int>(ExitCode::BadRequest));
}

TEST(MapsCommand, PrintsJson) {
    const Json maps = Json::parse(run_program("maps --json").out)["maps"];
    ASSERT_EQ(maps.size(), all_maps().size());
    EXPECT_EQ(maps[0]["name"], "albedo");
    EXPECT_EQ(maps[0]["channels"], "R G B");
    EXPECT_EQ(maps[0]["png_bits"], 8);
}

}  // namespace
}  // namespace foam::texgen
