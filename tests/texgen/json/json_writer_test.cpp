// SPDX-License-Identifier: Apache-2.0

#include "texgen/json/json_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

namespace foam::texgen {
namespace {

TEST(JsonWriter, ANumberThatIsNotFiniteIsNull) {
    EXPECT_EQ(number_or_null(0.25).dump(), "0.25");
    EXPECT_EQ(number_or_null({}).dump(), "null");
    EXPECT_EQ(number_or_null(std::nan("")).dump(), "null");
    EXPECT_EQ(number_or_null(-std::numeric_limits<double>::infinity()).dump(), "null");
}

TEST(JsonWriter, MembersKeepTheirOrder) {
    const std::vector<std::filesystem::path> paths = {"b/c.png", "a.png"};
    const Json value{{"z", 1}, {"a", path_list(paths)}};
    EXPECT_EQ(value.dump(), R"({"z":1,"a":["b/c.png","a.png"]})");
    EXPECT_EQ(path_list({}).dump(), "[]");
    EXPECT_EQ(indented({{"z", 1}}), "{\n  \"z\": 1\n}\n");
}

// A file name may have any bytes.
TEST(JsonWriter, TextThatIsNotUtf8IsReplaced) {
    const Json value{{"path", "a\xFF.png"}};
    EXPECT_EQ(json_text(value), "{\"path\":\"a\xEF\xBF\xBD.png\"}");
    EXPECT_EQ(indented(value), "{\n  \"path\": \"a\xEF\xBF\xBD.png\"\n}\n");
}

}  // namespace
}  // namespace foam::texgen
