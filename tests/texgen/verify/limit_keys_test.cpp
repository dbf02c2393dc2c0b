// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/limit_keys.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

const Key<CompareLimits>& key_at(std::string_view path) {
    const Key<CompareLimits>* const found = find_key(std::span(limit_keys()), path);
    EXPECT_NE(found, nullptr) << path;
    return *found;
}

TEST(LimitKeys, BothSeveritiesHaveTheSameLimits) {
    std::vector<std::string> paths;
    for (const KeyInfo& key : limit_keys()) {
        paths.push_back(key.path);
    }
    EXPECT_EQ(paths,
              (std::vector<std::string>{"fail",
                                        "fail_percent",
                                        "fail_pixels",
                                        "hard_fail",
                                        "fail_rms",
                                        "fail_percentile",
                                        "fail_angle",
                                        "warn",
                                        "warn_percent",
                                        "warn_pixels",
                                        "hard_warn",
                                        "warn_rms",
                                        "warn_percentile",
                                        "warn_angle"}));
    EXPECT_EQ(option_name(key_at("hard_fail")), "--hard-fail");
    EXPECT_TRUE(is_warning_key(key_at("hard_warn")));
    EXPECT_FALSE(is_warning_key(key_at("fail_rms")));
    EXPECT_TRUE(is_angle_key(key_at("warn_angle")));
    EXPECT_FALSE(is_angle_key(key_at("warn")));
}

TEST(LimitKeys, StoreTheLimitsOfTheirSeverity) {
    CompareLimits limits;
    EXPECT_TRUE(key_at("hard_warn").read({0.25}, limits));
    EXPECT_TRUE(key_at("fail_pixels").read({std::int64_t{3}}, limits));
    EXPECT_TRUE(key_at("fail_angle").read({std::int64_t{2}}, limits));
    EXPECT_EQ(limits.warn.hard, 0.25);
    EXPECT_FALSE(limits.fail.hard.has_value());
    EXPECT_EQ(limits.fail.allowed_pixels, 3);
    EXPECT_EQ(limits.fail.angle, 2.0);
}

TEST(LimitKeys, RejectNumbersOutOfRange) {
    CompareLimits limits;
    for (const double wrong : {std::nan(""), -1e-9, std::numeric_limits<double>::infinity()}) {
        for (const Key<CompareLimits>& key : limit_keys()) {
            EXPECT_FALSE(key.read({wrong}, limits)) << key.path << " " << wrong;
        }
    }
    EXPECT_FALSE(key_at("fail_percent").read({100.5}, limits));
    EXPECT_FALSE(key_at("fail_angle").read({181.0}, limits));
    EXPECT_FALSE(key_at("fail_pixels").read({1.5}, limits));
    EXPECT_FALSE(key_at("fail").read({std::string("0.1")}, limits));
}

TEST(LimitKeys, PercentilesAreTexts) {
    std::vector<PercentileLimit> limits;
    EXPECT_TRUE(PercentileLimits().read({std::string("99.9=0.01")}, limits));
    EXPECT_EQ(limits, (std::vector<PercentileLimit>{{99.9, 0.01}}));
    EXPECT_TRUE(PercentileLimits().read({std::string("50=0,100=1e-3")}, limits));
    EXPECT_EQ(limits, (std::vector<PercentileLimit>{{50.0, 0.0}, {100.0, 1e-3}}));
    EXPECT_EQ(*PercentileLimits().write(limits), (Value{std::string("50=0,100=0.001")}));
    for (const char* wrong :
         {"", "99", "=1", "99=", "0=1", "101=1", "99=-1", "99=nan", "nan=1", "99=1,", "99=1=2"}) {
        EXPECT_FALSE(PercentileLimits().read({std::string(wrong)}, limits)) << wrong;
    }
    EXPECT_EQ(limits.size(), 2U);  // unchanged
}

TEST(LimitKeys, ArgumentsAreNumbersOrTexts) {
    EXPECT_EQ(value_of_argument("3"), Value{std::int64_t{3}});
    EXPECT_EQ(value_of_argument(".5"), Value{0.5});
    EXPECT_EQ(value_of_argument("1e-3"), Value{1e-3});
    EXPECT_EQ(value_of_argument("1x"), Value{std::string("1x")});
    EXPECT_EQ(value_of_argument(""), Value{std::string()});
}

}  // namespace
}  // namespace foam::texgen
