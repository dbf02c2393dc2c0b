// SPDX-License-Identifier: Apache-2.0

#include "core/foam/honeycomb.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Json = nlohmann::json;

std::string torus64() {
    return (foam::test::data_folder() / "evolver/torus64.fe").string();
}

constexpr double kTorusEnergy = 120.765667254534;

void write_text(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name) << text;
}

TEST(RelaxCommand, BringsAFoamToEquilibrium) {
    const TemporaryFolder work;
    const Outcome outcome = run_program("relax " + torus64() + " -o out.fe", work);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.rfind("out.fe: 64 bubbles, energy 120.765667254", 0), 0U) << outcome.out;
    EXPECT_EQ(work.files(), std::vector<std::string>{"out.fe"});
    const Foam foam = read_evolver(file_content(work.path() / "out.fe"), "out.fe").foam;
    EXPECT_EQ(foam.network.bubble_count(), 64U);
}

TEST(RelaxCommand, PrintsOneJsonObject) {
    const Outcome outcome =
        run_program("relax " + torus64() + " --out out.json --threads 1 --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.size(), 9U);
    EXPECT_EQ(result.at("status"), "converged");
    EXPECT_EQ(result.at("bubbles"), 64);
    EXPECT_NEAR(result.at("energy").get<double>(), kTorusEnergy, 1e-9 * kTorusEnergy);
    EXPECT_LT(result.at("area_error").get<double>(), 1e-9);
    EXPECT_LT(result.at("angle_error").get<double>(), 1e-9);
    EXPECT_GT(result.at("iterations").get<int>(), 0);
    EXPECT_EQ(result.at("t1"), 0);
    EXPECT_EQ(result.at("t2"), 0);
    EXPECT_GT(result.at("seconds").get<double>(), 0.0);
}

TEST(RelaxCommand, StatesRoundTripForAnyNumberOfThreads) {
    const TemporaryFolder work;
    ASSERT_EQ(run_program("relax " + torus64() + " -o a.json -q --threads 1", work).code, 0);
    ASSERT_EQ(run_program("relax " + torus64() + " -o b.json -q --threads 3", work).code, 0);
    ASSERT_EQ(run_program("relax a.json -o c.fe -q", work).code, 0);
    ASSERT_EQ(run_program("relax c.fe -o d.fe -q", work).code, 0);
    EXPECT_EQ(file_content(work.path() / "a.json"), file_content(work.path() / "b.json"));
    const Foam state = read_foam_json(file_content(work.path() / "a.json"), "a.json");
    const Foam evolver = read_evolver(file_content(work.path() / "d.fe"), "d.fe").foam;
    EXPECT_TRUE(state.positions == evolver.positions);
}

TEST(RelaxCommand, QuietPrintsNothing) {
    const Outcome outcome = run_program("relax " + torus64() + " -o out.dmp -q");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(RelaxCommand, NotesMissingPartsOfAFoam) {
    const TemporaryFolder work;
    std::string text = file_content(torus64());
    text.insert(text.find("\n2 "), " fixed");
    write_text(work, "in.fe", text);
    const Outcome outcome = run_program("relax in.fe -o out.fe", work);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err,
              "foamtex: in.fe: note: fixed positions and constraints of 1 element are ignored\n");
}

TEST(RelaxCommand, AMalformedFileIsOneLineAndCode4) {
    const TemporaryFolder work;
    write_text(work, "in.fe", "STRING\nSPACE_DIMENSION 2\nTORUS\nvertices\n1 0 0\n2 0.5\nedges\n");
    const Outcome outcome = run_program("relax in.fe -o out.fe", work);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(outcome.err, "foamtex: in.fe:6: vertex 2: expected two coordinates\n");
    write_text(work, "in.json", "{\n\"format\": 3\n");
    EXPECT_EQ(run_program("relax in.json -o out.fe", work).err,
              "foamtex: in.json:2: syntax error while parsing object - unexpected end of input; "
              "expected '}'\n");
    EXPECT_EQ(work.files(), (std::vector<std::string>{"in.fe", "in.json"}));
}

TEST(RelaxCommand, AMissingFileIsCode4) {
    const Outcome outcome = run_program("relax none.fe -o out.fe");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(outcome.err, "foamtex: cannot read 'none.fe': No such file or directory\n");
}

// The output is checked first, because the solver may take long.
TEST(RelaxCommand, FindsAnOutputThatCannotBeWrittenBeforeItReads) {
    const Outcome outcome = run_program("relax none.fe -o /dev/null/out.fe");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(outcome.err, "foamtex: cannot write into '/dev/null': Not a directory\n");
}

TEST(RelaxCommand, UnknownExtensionsAreCode2) {
    for (const char* arguments : {"relax in.txt -o out.fe", "relax in.fe -o in.txt"}) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest));
        EXPECT_EQ(outcome.err,
                  "foamtex: 'in.txt': the name of a foam file must end in .fe, .dmp or .json\n");
    }
    EXPECT_EQ(run_program("relax in.fe").err,
              "foamtex: --out is required (see foamtex relax --help)\n");
}

// Each bubble of this torus is its own neighbor, so it cannot become as small as its target area.
TEST(RelaxCommand, WithoutEquilibriumNothingIsWritten) {
    const TemporaryFolder work;
    Foam foam = honeycomb(1, 2);
    foam.target_areas[BubbleId{0}] = 1e-4;
    foam.target_areas[BubbleId{1}] = 2.0 - 1e-4;
    write_text(work, "in.json", write_foam_json(foam));
    const Outcome outcome = run_program("relax in.json -o out.json --json", work);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::NoEquilibrium)) << outcome.out;
    EXPECT_EQ(outcome.err, "foamtex: in.json: the foam did not reach equilibrium\n");
    EXPECT_NE(Json::parse(outcome.out).at("status"), "converged");
    EXPECT_EQ(work.files(), std::vector<std::string>{"in.json"});
    // A file that causes a note still gives one line.
    std::string text = write_evolver(foam);
    const std::size_t vertices = text.find("vertices");
    ASSERT_NE(vertices, std::string::npos);
    text.insert(vertices, "quantity q FIXED = 0 METHOD m\n");
    write_text(work, "in.fe", text);
    const Outcome noted = run_program("relax in.fe -o out.json", work);
    EXPECT_EQ(noted.code, static_cast<int>(ExitCode::NoEquilibrium));
    EXPECT_TRUE(
        noted.err.starts_with("foamtex: in.fe: the foam did not reach equilibrium; note: line "))
        << noted.err;
    EXPECT_EQ(std::count(noted.err.begin(), noted.err.end(), '\n'), 1) << noted.err;
}

TEST(RelaxCommand, OutputErrorIsCode5) {
    const Outcome outcome = run_program("relax " + torus64() + " -o none/out.fe");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(outcome.err, "foamtex: cannot write 'none/out.fe': No such file or directory\n");
}

}  // namespace
}  // namespace foam::texgen
