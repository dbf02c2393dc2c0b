// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/job_file.h"

#include "tests/texgen/cli/run_program.h"
#include "texgen/preset/assignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using testing::ElementsAre;

std::string rejection_of(const std::string& toml) {
    try {
        read_jobs(toml, "jobs.toml");
    } catch (const PresetError& error) {
        return error.what();
    }
    return "";
}

TEST(JobFile, GivesOneCommandPerTable) {
    const std::vector<Job> jobs = read_jobs(R"(
[[bake]]
set = ["foam.seed=3", "foam.lloyd=2"]
preset = "lava"
size = 512
maps = ["albedo", "normal"]
stats = true

[[bake]]
preset = "my file.toml"
frames = "1-10x2"
maps = "albedo"
stats = false
)",
                                            "jobs.toml");
    ASSERT_EQ(jobs.size(), 2U);
    EXPECT_THAT(jobs[0].arguments,
                ElementsAre("bake",
                            "lava",
                            "--set",
                            "foam.seed=3",
                            "--set",
                            "foam.lloyd=2",
                            "--size",
                            "512",
                            "--maps",
                            "albedo,normal",
                            "--stats"));
    EXPECT_EQ(jobs[1].command(), "foamtex bake 'my file.toml' --frames 1-10x2 --maps albedo");
}

// A job has no keys for options that concern the run as a whole.
TEST(JobFile, HasAKeyForEveryOptionOfABake) {
    const std::set<std::string> others = {
        "help", "resume", "dry-run", "json", "quiet", "verbose", "progress", "watch"};
    const std::string help = run_program("bake --help").out;
    std::string toml = "[[bake]]\npreset = \"lava\"\n";
    std::size_t options = 0;
    const std::regex option("\n  (?:-[a-z],)?--([a-z-]+)");
    for (std::sregex_iterator found(help.begin(), help.end(), option), end; found != end; ++found) {
        const std::string name = (*found)[1];
        if (!others.contains(name)) {
            toml += name + " = " + (name == "stats" ? "true" : "\"1\"") + "\n";
            ++options;
        }
    }
    EXPECT_GT(options, 10U);
    EXPECT_EQ(rejection_of(toml), "");
}

TEST(JobFile, SaysWhatIsWrong) {
    EXPECT_EQ(rejection_of("[[bake]]\nsize = 3\n"), "jobs.toml: bake[1] has no preset");
    EXPECT_EQ(rejection_of(""), "jobs.toml: has no table [[bake]]");
    EXPECT_EQ(rejection_of("seed = 3\n"),
              "jobs.toml:1: key 'seed' is unknown; a job file has tables [[bake]]");
    EXPECT_EQ(rejection_of("[[bake]]\npreset = \"lava\"\nsize = [3]\n"),
              "jobs.toml:3: key 'bake[1].size' = [3]: must be a text or a number");
    EXPECT_EQ(rejection_of("[[bake]]\npreset = \"lava\"\nstats = 1\n"),
              "jobs.toml:3: key 'bake[1].stats' = 1: must be true or false");
    EXPECT_THAT(rejection_of("[[bake]]\npreset = \"lava\"\nsizes = 3\n"),
                testing::EndsWith("threads; did you mean 'size'?"));
    EXPECT_NE(rejection_of("[[bake]\n"), "");
}

}  // namespace
}  // namespace foam::texgen
