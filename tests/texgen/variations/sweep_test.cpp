// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> values_of(const Sweep& sweep) {
    std::vector<std::string> values;
    for (const Assignment& value : sweep.values) {
        EXPECT_EQ(value.key, sweep.key);
        values.push_back(to_toml(value.value));
    }
    return values;
}

std::string rejection_of(const std::string& argument) {
    try {
        read_sweep(argument);
    } catch (const PresetError& error) {
        return error.what();
    }
    return "";
}

TEST(Sweep, HasTheGivenValues) {
    const Sweep sweep = read_sweep("foam.lloyd=0,1,4");
    EXPECT_EQ(sweep.key, "foam.lloyd");
    EXPECT_THAT(values_of(sweep), ElementsAre("0", "1", "4"));
    EXPECT_THAT(values_of(read_sweep("albedo.colormap=magma,viridis")),
                ElementsAre("\"magma\"", "\"viridis\""));
}

TEST(Sweep, KeepsListsAndQuotedTextsWhole) {
    EXPECT_THAT(values_of(read_sweep("loop.drift=[0, 1],[1, 0]")), ElementsAre("[0, 1]", "[1, 0]"));
    EXPECT_THAT(values_of(read_sweep(R"(preset.description="a, b",'c, d')")),
                ElementsAre("\"a, b\"", "\"c, d\""));
}

TEST(Sweep, SpacesNumbersEvenly) {
    EXPECT_THAT(values_of(read_sweep("loop.amplitude=0.1..0.4:4")),
                ElementsAre("0.1", "0.2", "0.3", "0.4"));
    EXPECT_THAT(values_of(read_sweep("foam.lloyd=4..0:3,9")), ElementsAre("4", "2", "0", "9"));
}

TEST(Sweep, SeedsAreARange) {
    const Sweep sweep = read_seeds("3,7-9");
    EXPECT_EQ(sweep.key, "foam.seed");
    EXPECT_THAT(values_of(sweep), ElementsAre("3", "7", "8", "9"));
    EXPECT_THROW(read_seeds("x"), PresetError);
    EXPECT_THROW(read_seeds("1-401"), PresetError);
}

TEST(Sweep, AMalformedArgumentIsRejected) {
    for (const char* argument : {"foam.lloyd",
                                 "=3",
                                 "foam.lloyd=",
                                 "foam.lloyd=1,,2",
                                 "loop.current=0..1",
                                 "loop.current=0..1:1",
                                 "loop.current=a..1:2",
                                 "loop.current=0..1:401",
                                 "loop.current=..",
                                 "loop.current=0..inf:3"}) {
        EXPECT_THAT(rejection_of(argument), HasSubstr("--sweep " + std::string(argument) + ": "))
            << argument;
    }
}

}  // namespace
}  // namespace foam::texgen
