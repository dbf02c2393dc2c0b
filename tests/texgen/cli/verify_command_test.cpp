// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace foam::texgen {
namespace {

TEST(VerifyCommand, ReportsFailuresByItsExitCode) {
    const TemporaryFolder work;
    ASSERT_EQ(
        run_program("bake sea_foam --set foam.bubbles=16 --size 32 --frames 1-3 -q", work).code, 0);
    const Outcome good = run_program("verify out", work);
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_NE(good.out.find("sea_foam: seed 1, 32 x 32"), std::string::npos);
    EXPECT_NE(good.out.find("all checks passed"), std::string::npos);
    const Outcome json = run_program("verify out/manifest.json --json", work);
    EXPECT_EQ(nlohmann::json::parse(json.out)["status"], "holds");
    std::filesystem::remove(work.path() / "out" / "sea_foam_lit.0002.png");
    const Outcome bad = run_program("verify out", work);
    EXPECT_EQ(bad.code, static_cast<int>(ExitCode::CheckFailed));
    EXPECT_NE(bad.out.find("FAILED"), std::string::npos);
    const Outcome quiet = run_program("verify out -q", work);
    EXPECT_EQ(quiet.code, static_cast<int>(ExitCode::CheckFailed));
    EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(VerifyCommand, AFolderWithoutAManifestIsCode4) {
    const Outcome outcome = run_program("verify .");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(outcome.err,
              "foamtex: '.' has no manifest.json: foamtex has baked no images into this folder\n");
}

}  // namespace
}  // namespace foam::texgen
