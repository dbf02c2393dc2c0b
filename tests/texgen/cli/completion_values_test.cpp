// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/completion_values.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Words = std::vector<std::string>;

TEST(CompletionValues, FollowFromTheArgument) {
    const CompletionWords words{{"sea_foam"}, {"albedo"}, {"foam.seed"}, {}, {"foam"}, {"unreal"}};
    const auto values = [&](const char* name, const char* value) {
        return values_of({{name}, value, ""}, words);
    };
    EXPECT_EQ(values("--maps", "A,B").kind, ValueKind::List);
    EXPECT_EQ(values("--maps", "A,B").words, Words{"albedo"});
    EXPECT_EQ(values("--scene", "A,B").kind, ValueKind::List);
    EXPECT_EQ(values("--scene", "A,B").words, (Words{"usda", "mtlx", "gltf"}));
    EXPECT_EQ(values("--map", "MAP").kind, ValueKind::Words);
    EXPECT_EQ(values("--map", "MAP").words, Words{"albedo"});
    EXPECT_EQ(values("MAP", "").words, Words{"albedo"});
    EXPECT_EQ(values("TABLE", "").words, Words{"foam"});
    EXPECT_EQ(values("--set", "KEY=VALUE").kind, ValueKind::Key);
    EXPECT_EQ(values("--set", "KEY=VALUE").words, Words{"foam.seed"});
    EXPECT_EQ(values("PRESET", "").words, Words{"sea_foam"});
    EXPECT_EQ(values("--for", "PROFILE").words, Words{"unreal"});
    EXPECT_EQ(values("PROFILE", "").words, Words{"unreal"});
    EXPECT_EQ(values("--normal-y", "gl|dx").words, (Words{"gl", "dx"}));
    EXPECT_EQ(values("--out", "PATTERN").kind, ValueKind::Path);
    EXPECT_EQ(joined({"a", "b"}), "a b");
}

}  // namespace
}  // namespace foam::texgen
