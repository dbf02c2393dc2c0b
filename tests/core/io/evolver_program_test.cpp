// SPDX-License-Identifier: Apache-2.0

// Tests that Surface Evolver reads the files that we write, and agrees with our equilibrium.
// Skipped if Evolver is not installed.
#include "core/dynamics/shear.h"
#include "core/equilibrium/equilibrate_given.h"
#include "core/foam/measure.h"
#include "core/foam/stress.h"
#include "core/io/evolver_file.h"
#include "tests/core/foams.h"
#include "tests/core/io/data_file.h"
#include "tests/core/io/small_torus.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace foam {
namespace {

constexpr double kTolerance = 1e-9;

bool evolver_is_installed() {
    return std::system("command -v evolver >/dev/null") == 0;  // NOLINT(cert-env33-c)
}

// The result of running Evolver: its exit code (-1 if it did not exit normally), the numbers that
// it printed after the word "value", all its output, and the content of a.dmp, to which it may
// write a dump.
struct Session {
    int code = -1;
    std::vector<double> values;
    std::string log;
    std::string dump;
};

std::string content(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<double> values_in(const std::string& log) {
    std::vector<double> values;
    std::istringstream words(log);
    for (std::string word; words >> word;) {
        if (word == "value" && words >> word) {
            values.push_back(std::stod(word));
        }
    }
    return values;
}

// Loads a data file in Evolver and runs commands, for at most a minute.
Session run_evolver(const std::string& data_file, const std::string& commands) {
    std::string folder = (std::filesystem::temp_directory_path() / "evolver-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        return {};
    }
    std::ofstream(folder + "/a.fe") << data_file;
    std::ofstream(folder + "/commands") << commands << "q\nq\n";
    const std::string line = "cd " + folder + " && timeout 60 evolver a.fe <commands >log 2>&1";
    const int status = std::system(line.c_str());  // NOLINT(cert-env33-c)
    const std::string log = content(folder + "/log");
    const std::string dump = content(folder + "/a.dmp");
    std::filesystem::remove_all(folder);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, values_in(log), log, dump};
}

// Print the energy and the areas and pressures of all bodies, before and after a Newton step. On a
// torus the areas depend on each other, so that the matrix of this step is singular up to Evolver's
// rounding errors. The step fails for some foams.
constexpr const char* kCommands = R"(recalc
printf "value %.17g\n",total_energy
foreach body bb do printf "value %.17g\n",bb.volume
foreach body bb do printf "value %.17g\n",bb.pressure
hessian
printf "value %.17g\n",total_energy
foreach body bb do printf "value %.17g\n",bb.volume
foreach body bb do printf "value %.17g\n",bb.pressure
)";

// Expects that Evolver loaded the foam without errors and computed the same energy, areas and
// pressures, before and after its Newton step. Pressures on a torus are relative to bubble 0.
void expect_same(const Foam& foam, const Session& session) {
    const std::size_t bubbles = foam.network.bubble_count();
    EXPECT_EQ(session.code, 0) << session.log;
    const std::string loading = session.log.substr(0, session.log.find("hessian"));
    EXPECT_EQ(loading.find("WARNING"), std::string::npos) << session.log;
    EXPECT_EQ(loading.find("ERROR"), std::string::npos) << session.log;
    ASSERT_EQ(session.values.size(), 2 * (1 + 2 * bubbles)) << session.log;
    double area = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        area += foam.target_areas[bubble];
    }
    const double unit = foam.film_tension / std::sqrt(area / static_cast<double>(bubbles));
    const double reference = foam.domain.is_plane() ? 0.0 : foam.pressures[BubbleId{0}];
    for (std::size_t start : {std::size_t{0}, 1 + 2 * bubbles}) {
        const double* value = &session.values[start];
        EXPECT_NEAR(*value / energy(foam), 1.0, kTolerance);
        for (std::size_t k = 0; k < bubbles; ++k) {
            const auto bubble = id_at<BubbleId>(k);
            EXPECT_NEAR(value[1 + k] / bubble_area(foam, bubble), 1.0, kTolerance);
            const double pressure = foam.pressures[bubble] - reference;
            EXPECT_NEAR((value[1 + bubbles + k] - pressure) / unit, 0.0, 1e-7);
        }
    }
}

class EvolverProgram : public testing::Test {
  protected:
    void SetUp() override {
        if (!evolver_is_installed()) {
            GTEST_SKIP() << "evolver is not installed";
        }
    }
};

TEST_F(EvolverProgram, AgreesWithOurEquilibriumOfAWrittenFile) {
    for (const char* name : {"evolver/torus64.fe", "evolver/torus1024.fe"}) {
        Foam foam = read_evolver(test::data_file(name), name).foam;
        ASSERT_TRUE(equilibrate_given(foam, 0).converged());
        expect_same(foam, run_evolver(write_evolver(foam), kCommands));
    }
}

// Nothing holds a free cluster in its position, so that `hessian` would be singular. `hessian_seek`
// replaces it.
TEST_F(EvolverProgram, AgreesWithOurEquilibriumOfAFreeCluster) {
    const std::string commands = [] {
        std::string text = kCommands;
        return text.replace(text.find("hessian\n"), 8, "hessian_seek\n");
    }();
    for (const char* name : {"evolver/cluster37.fe", "evolver/cluster331.fe"}) {
        Foam foam = read_evolver(test::data_file(name), name).foam;
        ASSERT_TRUE(equilibrate_given(foam, 0).converged());
        expect_same(foam, run_evolver(write_evolver(foam), commands));
    }
    Foam three = test::triple_bubble(1.0);
    ASSERT_TRUE(equilibrate_given(three, 0).converged());
    expect_same(three, run_evolver(write_evolver(three), commands));
}

// Returns the energy of the equilibrium that Evolver finds from the state of a foam by Newton's
// method.
double evolver_energy(const Foam& foam) {
    const Session session = run_evolver(write_evolver(foam),
                                        "recalc\naugmented_hessian on\nhessian\nhessian\nhessian\n"
                                        "hessian\nhessian\nhessian\n"
                                        "printf \"value %.17g\\n\",total_energy\n");
    EXPECT_EQ(session.values.size(), 1U) << session.log;
    return session.values.empty() ? 0.0 : session.values[0];
}

// In simple shear, the slope of the energy per area is the shear stress (E11). The derivative is a
// central difference of the fourth order.
TEST_F(EvolverProgram, ItsEnergyOfAShearedTorusHasOurStressAsItsSlope) {
    const Foam foam = test::equilibrated_foam(100, 7);
    constexpr double kStrain = 0.001;
    const auto energy_at = [&](double strain) {
        Foam copy = foam;
        shear(copy, strain);
        return evolver_energy(copy);
    };
    const double near = energy_at(kStrain) - energy_at(-kStrain);
    const double far = energy_at(2.0 * kStrain) - energy_at(-2.0 * kStrain);
    const double slope = (8.0 * near - far) / (12.0 * kStrain);
    EXPECT_NEAR(slope / foam.domain.area(), mean_stress(snapshot(foam, 1))(0, 1), 1e-10);
}

TEST_F(EvolverProgram, TakesOtherUnitsAndAreas) {
    Foam foam = test::equilibrated_foam(100, 7);
    foam.domain = {3.0 * foam.domain.width, 3.0 * foam.domain.height};
    foam.film_tension = 0.25;
    for (Vec2& position : foam.positions) {
        position *= 3.0;
    }
    for (double& area : foam.target_areas) {
        area *= 9.0;
    }
    ASSERT_TRUE(equilibrate_given(foam, 0).converged());
    expect_same(foam, run_evolver(write_evolver(foam), kCommands));
}

// On these tori bubbles are their own neighbors.
TEST_F(EvolverProgram, TakesTheSmallestFoams) {
    Foam one = read_evolver(test::kSmallTorus, "a.fe").foam;
    ASSERT_TRUE(equilibrate_given(one, 0).converged());
    expect_same(one, run_evolver(write_evolver(one), kCommands));
    const Foam few = test::equilibrated_foam(3, 2);
    expect_same(few, run_evolver(write_evolver(few), kCommands));
}

TEST_F(EvolverProgram, TakesStraightFilms) {
    Foam foam = test::raw_foam(20, 4);
    const Session session = run_evolver(write_evolver(foam, EvolverEdges::Straight),
                                        "recalc\nprintf \"value %.17g\\n\",total_energy\n");
    ASSERT_EQ(session.values.size(), 1U) << session.log;
    EXPECT_NEAR(session.values[0] / energy(foam), 1.0, kTolerance);  // all pressures are 0
}

TEST_F(EvolverProgram, AddsTheSameEnergiesToTheTension) {
    for (const char* energies :
         {"METHOD_INSTANCE len METHOD edge_length MODULUS 2\nQUANTITY qq ENERGY GLOBAL_METHOD len",
          "METHOD_INSTANCE len METHOD edge_length MODULUS 2 GLOBAL\n"
          "QUANTITY qq ENERGY METHOD len MODULUS 3",
          "QUANTITY qq ENERGY MODULUS 7 GLOBAL_METHOD edge_length MODULUS 2\n"
          "GLOBAL_METHOD edge_length MODULUS 3",
          "METHOD_INSTANCE len METHOD edge_length MODULUS 2\n"
          "QUANTITY qq ENERGY MODULUS 11 GLOBAL_METHOD len MODULUS 3 GLOBAL_METHOD edge_length"}) {
        const std::string text =
            test::edited(test::kSmallTorus, "vertices", std::string(energies) + "\nvertices");
        const Session session =
            run_evolver(text, "printf \"value %.17g\\n\",total_energy/total_length\n");
        ASSERT_EQ(session.values.size(), 1U) << session.log;
        EXPECT_NEAR(read_evolver(text, "a.fe").foam.film_tension, session.values[0], kTolerance)
            << energies;
    }
}

// The dump contains elements that users may add: fixed vertices, constraints, colors, attributes
// and quantities.
TEST_F(EvolverProgram, ItsDumpsCanBeRead) {
    const Foam foam = test::equilibrated_foam(30, 6);
    std::ostringstream formula;  // vertex 4 satisfies this constraint
    formula << std::setprecision(17) << "formula: x = " << foam.positions[JunctionId{3}].x();
    std::string text = test::edited(write_evolver(foam),
                                    "TORUS_FILLED",
                                    "constraint 1\nFORMULA\n"
                                    "quantity arcs info_only method circular_arc_length global\n"
                                    "define edge attribute mine real[2]\nparameter knob = 3\n"
                                    "TORUS_FILLED");
    text = test::edited(text, "FORMULA", formula.str());
    const Session session = run_evolver(text,
                                        "set vertex[3] fixed\nset edge color red where id < 9\n"
                                        "set edge[2] mine[1] 5\nset vertex[4] constraint 1\n"
                                        "dump \"a.dmp\"\n");
    ASSERT_EQ(session.code, 0) << session.log;
    const EvolverFoam read = read_evolver(session.dump, "a.dmp");
    EXPECT_EQ(read.notes.size(), 1U);
    EXPECT_NEAR(energy(read.foam) / energy(foam), 1.0, 1e-12);
    EXPECT_LT(equilibrium_errors(read.foam).area, 1e-9);
}

}  // namespace
}  // namespace foam
