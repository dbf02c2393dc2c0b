// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

constexpr const char* kComplete = R"(
source completion.bash
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_foamtex
echo "${COMPREPLY[@]}"
)";

// Returns the words that bash offers as completions of the last word of a command line.
std::string offered(const std::string& words) {
    const TemporaryFolder work;
    std::ofstream(work.path() / "completion.bash") << run_program("completion bash").out;
    std::ofstream(work.path() / "complete.sh") << kComplete;
    return run_program("--version >/dev/null; bash complete.sh " + words, work).out;
}

TEST(BashCompletion, OffersCommandsOptionsAndValues) {
    EXPECT_EQ(offered("foamtex re"), "render relax\n");
    EXPECT_EQ(offered("foamtex bake --norm"), "--normal-y\n");
    EXPECT_EQ(offered("foamtex bake --normal-y ''"), "gl dx\n");
    EXPECT_EQ(offered("foamtex bake sea_f"), "sea_foam\n");
    EXPECT_EQ(offered("foamtex presets show lab"), "labyrinth\n");
    EXPECT_EQ(offered("foamtex verify --preset lab"), "labyrinth\n");
    EXPECT_EQ(offered("foamtex presets keys lo"), "loop\n");
    EXPECT_EQ(offered("foamtex maps maz"), "maze maze_solution\n");
    EXPECT_EQ(offered("foamtex maps compl"), "\n");  // no file
    EXPECT_EQ(offered("foamtex bake --set foam.bub"), "foam.bubbles=\n");
}

// Bash splits KEY=VALUE into three words, unless '=' is not in COMP_WORDBREAKS.
TEST(BashCompletion, OffersTheValuesOfAKey) {
    EXPECT_EQ(offered("foamtex bake --set albedo.colormap = ma"), "magma\n");
    EXPECT_EQ(offered("foamtex bake --set relief.profile ="), "dome ridge wet\n");
    EXPECT_EQ(offered("foamtex vary --sweep relief.profile ="), "dome ridge wet\n");
    EXPECT_EQ(offered("foamtex bake --set albedo.colormap=ma"), "albedo.colormap=magma\n");
    EXPECT_EQ(offered("foamtex bake --set foam.seed = ''"), "\n");
}

TEST(BashCompletion, OffersTheNextOfAList) {
    EXPECT_EQ(offered("foamtex bake sea_foam --maps albedo,curv"), "albedo,curvature\n");
}

TEST(BashCompletion, OffersFilesWhereNoNameFits) {
    EXPECT_EQ(offered("foamtex bake compl"), "complete.sh completion.bash\n");
    EXPECT_EQ(offered("foamtex relax compl"), "complete.sh completion.bash\n");
}

}  // namespace
}  // namespace foam::texgen
