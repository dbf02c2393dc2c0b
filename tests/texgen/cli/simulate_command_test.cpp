// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace foam::texgen {
namespace {

const char* const kSmall = "simulate sea_foam --set foam.bubbles=16 --frames 1-2 --size 16 ";

TEST(SimulateCommand, FillsACache) {
    const Outcome outcome = run_program(std::string(kSmall) + "--cache foam");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "foam\n");
    for (const char* const name : {"foam/cache.json", "foam/state.000001.foam"}) {
        EXPECT_EQ(std::ranges::count(outcome.written, name), 1) << name;
    }
    EXPECT_EQ(run_program(std::string(kSmall) + "--cache foam -q").out, "");
}

TEST(SimulateCommand, NeedsAFolder) {
    expect_rejected(kSmall, "--cache is required (see foamtex --help)");
}

}  // namespace
}  // namespace foam::texgen
