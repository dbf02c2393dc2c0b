// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/cli/exit_code.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

/// A folder with a job file of three jobs. The second one has a size that is not allowed.
class RunCommand : public testing::Test {
  protected:
    RunCommand() {
        constexpr const char* kSmall =
            "size = 16\nset = [\"foam.bubbles=12\", \"loop.kind=none\"]\nmaps = [\"albedo\"]\n";
        std::ofstream(folder_.path() / "jobs.toml")
            << "[[bake]]\npreset = \"sea_foam\"\nframes = \"1-2\"\nout = \"a/####.png\"\n"
            << kSmall << "[[bake]]\npreset = \"sea_foam\"\nsize = 0\n"
            << "[[bake]]\npreset = \"sea_foam\"\nframes = 1\nout = \"b.png\"\n"
            << kSmall;
    }

    TemporaryFolder folder_;
};

TEST_F(RunCommand, AFailedJobDoesNotStopTheOthers) {
    const Outcome outcome = run_program("run jobs.toml", folder_);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(outcome.out, "a/####.png 1-2\nb.png\n2 of 3 jobs complete\n");
    EXPECT_NE(outcome.err.find("foamtex: job 2 ended with exit code 2: foamtex bake sea_foam "
                               "--size 0\n"),
              std::string::npos)
        << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "a" / "0002.png"));
}

TEST_F(RunCommand, RunsOneJob) {
    const Outcome outcome = run_program("run jobs.toml --job 3 -q", folder_);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "b.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a"));
    EXPECT_EQ(run_program("run jobs.toml --array-index 4", folder_).err,
              "foamtex: --job 4: 'jobs.toml' has 3 jobs\n");
}

TEST_F(RunCommand, KeepsFramesThatExist) {
    run_program("run jobs.toml -q", folder_);
    const auto file = folder_.path() / "a" / "0001.png";
    const auto time = std::filesystem::last_write_time(file);
    const Outcome again = run_program("run jobs.toml --json", folder_);
    EXPECT_EQ(std::filesystem::last_write_time(file), time);
    EXPECT_NE(again.out.find("\"failed\":1"), std::string::npos) << again.out;
}

TEST_F(RunCommand, TheReportIsCompleteIfAllJobsAre) {
    const auto status = [&](const std::string& arguments) {
        const Outcome outcome = run_program("run jobs.toml --json" + arguments, folder_);
        return nlohmann::json::parse(outcome.out).at("status").get<std::string>();
    };
    EXPECT_EQ(status(" --job 3"), "complete");
    EXPECT_EQ(status(" --job 2"), "failed");
    EXPECT_EQ(status(""), "failed");
}

TEST_F(RunCommand, AMissingFileIsOneLine) {
    const Outcome outcome = run_program("run nothing.toml", folder_);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(outcome.err, "foamtex: cannot read 'nothing.toml': No such file or directory\n");
}

}  // namespace
}  // namespace foam::texgen
