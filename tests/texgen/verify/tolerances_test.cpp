// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/tolerances.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "texgen/preset/assignment.h"

#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <string>

namespace foam::texgen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns the message of the PresetError that parsing throws, or an empty string.
std::string error_of(const std::string& toml) {
    try {
        parse_tolerances(toml, "t.toml");
    } catch (const PresetError& error) {
        return error.what();
    }
    return "";
}

TEST(Tolerances, AMapHasItsTableOrTheDefault) {
    const Tolerances tolerances = parse_tolerances(R"(
[default]
fail = 0.002
warn = 0.001

[normal]
fail = 0.01
fail_percent = 0.0001
fail_percentile = "99=0.001,99.9=0.01"
fail_angle = 2
)",
                                                   "t.toml");
    const CompareLimits normal = tolerances.limits_of("normal");
    EXPECT_EQ(normal.fail.sample, 0.01);
    EXPECT_EQ(normal.fail.allowed_percent, 0.0001);
    EXPECT_EQ(normal.fail.percentiles.size(), 2U);
    EXPECT_EQ(normal.fail.angle, 2.0);
    for (const char* map : {"albedo", "", "unknown"}) {
        EXPECT_EQ(tolerances.limits_of(map).fail.sample, 0.002);
        EXPECT_EQ(tolerances.limits_of(map).warn.sample, 0.001);
        EXPECT_FALSE(tolerances.limits_of(map).fail.angle.has_value());
    }
}

TEST(Tolerances, ATableWithoutWarningsGivesNone) {
    const Tolerances tolerances =
        parse_tolerances("[normal]\nfail = 0.1\n[height]\nwarn_rms = 1", "");
    EXPECT_EQ(tolerances.limits_of("normal").warn.sample_limit(true), kInfinity);
    EXPECT_EQ(tolerances.limits_of("height").warn.rms, 1.0);
    EXPECT_EQ(tolerances.limits_of("height").fail.sample_limit(false), kDefaultSampleLimit);
}

// A map that no table concerns is compared as without the file.
TEST(Tolerances, WithoutADefaultTableTheDefaultsHold) {
    const Tolerances tolerances = parse_tolerances("[normal]\nfail = 0.1", "");
    EXPECT_EQ(tolerances.limits_of("albedo").fail.sample_limit(false), kDefaultSampleLimit);
    EXPECT_EQ(tolerances.limits_of("albedo").warn.sample_limit(false), kDefaultSampleLimit);
    EXPECT_EQ(Tolerances().limits_of("albedo").fail.sample_limit(false), kDefaultSampleLimit);
}

TEST(Tolerances, ErrorsNameLineKeyAndAllowedValues) {
    EXPECT_EQ(error_of("[default]\n\nfail = \"big\""),
              "t.toml:3: key 'default.fail' = \"big\": must be a number from 0 to 1e+300");
    EXPECT_EQ(error_of("[default]\nfail = nan"),
              "t.toml:2: key 'default.fail' = nan: must be a number from 0 to 1e+300");
    EXPECT_EQ(error_of("[normal]\nfail_percent = 101"),
              "t.toml:2: key 'normal.fail_percent' = 101: must be a number from 0 to 100");
    EXPECT_EQ(error_of("[normal]\nfail_pixels = 0.5"),
              "t.toml:2: key 'normal.fail_pixels' = 0.5: must be an integer from 0 to "
              "1000000000000");
    EXPECT_EQ(
        error_of("[normal]\nfail_percentile = \"99\""),
        "t.toml:2: key 'normal.fail_percentile' = \"99\": must be \"P=T\" (at least P percent of "
        "the pixels differ by at most T), or several, separated by commas, with P above 0 "
        "and at most 100, and T at least 0");
    EXPECT_EQ(error_of("[albedo]\nfail_angle = 1"),
              "t.toml:2: key 'albedo.fail_angle' = 1: only the tables of normal maps (normal, "
              "normal_gl, normal_dx) and [default] have limits of angles");
}

TEST(Tolerances, UnknownNamesAreComparedWithKnownOnes) {
    EXPECT_EQ(error_of("[normal]\nfail_angel = 1"),
              "t.toml:2: key 'normal.fail_angel' = 1: unknown key; did you mean 'fail_angle'?");
    EXPECT_EQ(error_of("[nomral]\nfail = 1"),
              "t.toml:1: key 'nomral' = {...}: unknown table; did you mean 'normal'?");
    EXPECT_EQ(error_of("fail = 1"),
              "t.toml:1: key 'fail' = 1: must be in a table: [default], or the name of a map such "
              "as [normal]");
    EXPECT_NE(error_of("[normal]\nxyzzyxyzzy = 1").find("unknown key; must be one of fail, "),
              std::string::npos);
    EXPECT_NE(error_of("[xyzzyxyzzy]").find("unknown table; must be one of albedo, "),
              std::string::npos);
    EXPECT_NE(error_of("[[normal]]\nfail = 1").find("unknown table; did you mean 'normal'?"),
              std::string::npos);
    EXPECT_NE(error_of("[normal.fail]\nx = 1").find("key 'normal.fail' = {...}: must be a number"),
              std::string::npos);
    EXPECT_EQ(error_of("[normal\nfail = 1").rfind("t.toml:1: malformed TOML: ", 0), 0U);
}

TEST(Tolerances, AreReadFromAFile) {
    const TemporaryFolder folder;
    const std::string toml = "[default]\nfail = 0.5\n";
    write_file(folder.path() / "t.toml", std::as_bytes(std::span(toml)));
    EXPECT_EQ(read_tolerances(folder.path() / "t.toml").limits_of("id").fail.sample, 0.5);
    EXPECT_THROW(read_tolerances(folder.path() / "none.toml"), PresetError);
}

}  // namespace
}  // namespace foam::texgen
