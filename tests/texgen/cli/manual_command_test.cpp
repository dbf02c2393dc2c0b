// What the program says of itself to shells and readers of manuals.
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

// The words that bash offers for the last of a command line.
std::string offered(const std::string& words) {
    const TemporaryFolder work;
    std::ofstream(work.path() / "completion.bash") << run_program("completion bash").out;
    std::ofstream(work.path() / "complete.sh") << kComplete;
    return run_program("--version >/dev/null; bash complete.sh " + words, work).out;
}

TEST(Completion, OffersCommandsOptionsAndValues) {
    EXPECT_EQ(offered("foamtex re"), "render relax\n");
    EXPECT_EQ(offered("foamtex bake --norm"), "--normal-y\n");
    EXPECT_EQ(offered("foamtex bake --normal-y ''"), "gl dx\n");
    EXPECT_EQ(offered("foamtex bake sea_f"), "sea_foam\n");
    EXPECT_EQ(offered("foamtex presets show lab"), "labyrinth\n");
    EXPECT_EQ(offered("foamtex bake --set foam.bub"), "foam.bubbles=\n");
}

TEST(Completion, OffersTheNextOfAList) {
    EXPECT_EQ(offered("foamtex bake sea_foam --maps albedo,curv"), "albedo,curvature\n");
}

TEST(Completion, OffersFilesWhereNoNameFits) {
    EXPECT_EQ(offered("foamtex bake compl"), "complete.sh completion.bash\n");
    EXPECT_EQ(offered("foamtex relax compl"), "complete.sh completion.bash\n");
}

TEST(Completion, OfZshKnowsEveryCommand) {
    const std::string script = run_program("completion zsh").out;
    EXPECT_TRUE(script.starts_with("#compdef foamtex\n"));
    for (const char* command : {"bake", "presets_show", "compare", "verify"}) {
        EXPECT_NE(script.find(std::string("\n_foamtex_") + command + "() {"), std::string::npos)
            << command;
    }
}

TEST(Manual, HasEveryCommandAndNoLineThatIsARequestByMistake) {
    const std::string page = run_program("manual").out;
    EXPECT_TRUE(page.starts_with(".TH FOAMTEX 1 "));
    EXPECT_NE(page.find(".SS foamtex bake [OPTIONS] PRESET\n"), std::string::npos);
    EXPECT_NE(page.find(".SS foamtex presets show [OPTIONS] NAME\n"), std::string::npos);
    std::size_t at = 0;
    while ((at = page.find("\n.", at)) != std::string::npos) {
        const std::string_view line = std::string_view(page).substr(at + 2, 3);
        const bool known = line.starts_with("SH ") || line.starts_with("SS ") ||
                           line.starts_with("TP\n") || line.starts_with("PP\n") || line == "nf\n" ||
                           line == "fi\n";
        EXPECT_TRUE(known) << line;
        ++at;
    }
}

}  // namespace
}  // namespace foam::texgen
