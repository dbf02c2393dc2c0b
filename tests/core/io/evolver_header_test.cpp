// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_header.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::evolver {
namespace {

const std::string file_name = "a.fe";

// Returns the header of a data file with the given lines between the model and the vertices.
Header header_with(const std::string& lines) {
    const std::string text = "STRING\nSPACE_DIMENSION 2\nTORUS_FILLED\n" + lines + "\nVERTICES\n";
    TokenReader reader(text, file_name);
    Header header = read_header(reader);
    EXPECT_TRUE(reader.at_word("vertices"));
    return header;
}

void expect_rejected(const std::string& text, const std::string& what) {
    test::expect_format_error(
        [&] {
            TokenReader reader(text, file_name);
            read_header(reader);
        },
        what);
}

TEST(EvolverHeader, ReadsTheTorus) {
    const Header header = header_with("parameter lx = 2*sqrt(3)\nPERIODS\nlx 0\n0 lx/2");
    EXPECT_EQ(header.domain.width, 2.0 * std::sqrt(3.0));
    EXPECT_EQ(header.domain.height, header.domain.width / 2.0);
    EXPECT_EQ(header_with("").domain.width, 1.0);  // Evolver's default
}

TEST(EvolverHeader, ReadsEveryFormOfATorus) {
    for (const char* text :
         {"surface_dimension 1 space_dimension 2 torus torus_periods 3 0 0 2 vertices",
          "string Space_Dimension 2 Torus_Filled periods 3 0 0 2 Vertices",
          "STRING SPACE_DIMENSION 2 SYMMETRY_GROUP \"torus\" PERIODS 3 0 0 2 VERTEX"}) {
        TokenReader reader(text, file_name);
        EXPECT_EQ(read_header(reader).domain.height, 2.0) << text;
    }
}

TEST(EvolverHeader, IgnoresStatementsWithoutEffectOnEquilibrium) {
    const Header header = header_with(R"(
vertices_predicted       321
// Total energy: 120.765667254535
SCALE: 0.110419606880075 fixed
length_method_name "circular_arc_length"
QUADRATIC
CONSTRAINT 1
formula: x^2 + y^2 = 3
energy:
e1: y^2
e2: 0
define vertex attribute foo real[2]
define facet attribute center real [2] // seeds
VIEW_MATRIX
  0.25 0 -1
  0 0.25 -1
  0 0 1
slice_coeff = { 1.00000, 0.00000, 0.00000}
procedure settle ( real much )
{ refine edges
  vertices ...
}
INTEGRAL_ORDER_1D: 5
quantity mylen;
METHOD_INSTANCE leng METHOD circular_arc_length global
QUANTITY mylen INFO_ONLY  method leng)");
    EXPECT_EQ(header.added_tension, 0.0);
    EXPECT_TRUE(header.notes.empty());
}

TEST(EvolverHeader, RejectsAPreprocessorLineAfterAnIgnoredStatement) {
    expect_rejected("STRING\ngravity_constant 0\n#define LX 3\nPERIODS\nLX 0\n0 2\nvertices",
                    "a.fe:3: preprocessor lines such as #define and #include are not supported");
}

TEST(EvolverHeader, AnEnergyOfAllLengthsAddsToTheTension) {
    EXPECT_EQ(header_with("quantity q energy modulus 0.5 method circular_arc_length global")
                  .added_tension,
              0.5);
    EXPECT_EQ(header_with("method_instance m method edge_length global\n"
                          "quantity q energy\n method m\n modulus 2*2\n")
                  .added_tension,
              4.0);
    EXPECT_EQ(header_with("quantity q energy global_method edge_length").added_tension, 1.0);
    EXPECT_EQ(header_with("quantity q energy modulus 0 method gravity_method").added_tension, 0.0);
}

TEST(EvolverHeader, AddsEveryMethodOfAnEnergyTimesItsModulus) {
    EXPECT_EQ(header_with("method_instance m method edge_length modulus 2\n"
                          "quantity q energy modulus 3 global_method m")
                  .added_tension,
              6.0);
    EXPECT_EQ(header_with("method_instance m method edge_length modulus 2 global\n"
                          "quantity q energy method m modulus 3")
                  .added_tension,
              6.0);
    EXPECT_EQ(header_with("quantity q energy global_method edge_length\n"
                          " global_method edge_length")
                  .added_tension,
              2.0);
    EXPECT_EQ(header_with("quantity q energy modulus 7 method edge_length global modulus 2\n"
                          "method circular_arc_length global\nmodulus 3")
                  .added_tension,
              35.0);
    EXPECT_EQ(header_with("quantity q energy global_method edge_length\n"
                          " global_method gravity_method modulus 0")
                  .added_tension,
              1.0);
}

TEST(EvolverHeader, RejectsOtherEnergies) {
    const std::string start = "STRING SPACE_DIMENSION 2 TORUS\n";
    const std::string what =
        "a.fe:2: quantity 'q' adds an energy that is not supported; only the length of all edges "
        "is supported";
    expect_rejected(start + "quantity q energy method circular_arc_length\nvertices", what);
    expect_rejected(start + "quantity q energy method vertex_scalar_integral global\nvertices",
                    what);
    expect_rejected(start +
                        "quantity q energy global_method gravity_method global_method edge_length\n"
                        "vertices",
                    what);
    expect_rejected(
        start + "quantity q energy global_method edge_length element_modulus w\nvertices", what);
    expect_rejected(start + "square_curvature 0.1\nvertices",
                    "a.fe:2: square_curvature adds an energy that is not supported; the energy of "
                    "a foam is the length of its films");
}

TEST(EvolverHeader, NotesQuantitiesThatAreNotHeldFixed) {
    const Header header = header_with("quantity q fixed = 3 method edge_length global");
    ASSERT_EQ(header.notes.size(), 1U);
    EXPECT_EQ(header.notes[0],
              "line 4: quantity 'q' is FIXED or CONSERVED in the file; foamtex ignores this");
}

TEST(EvolverHeader, AFreeClusterLiesInThePlane) {
    TokenReader reader("STRING\nSPACE_DIMENSION 2\nvertices", file_name);
    EXPECT_TRUE(read_header(reader).domain.is_plane());
    EXPECT_FALSE(header_with("").domain.is_plane());
}

TEST(EvolverHeader, RejectsOtherModels) {
    expect_rejected(
        "SPACE_DIMENSION 2\nTORUS\nvertices",
        "a.fe:3: the top section must contain STRING; only string models are supported");
    expect_rejected("STRING\nTORUS\nvertices",
                    "a.fe:3: the top section must contain SPACE_DIMENSION 2; the dimension is 3");
    expect_rejected("SOAPFILM\n",
                    "a.fe:1: SOAPFILM selects a model that is not supported; only STRING models "
                    "with the Euclidean metric are supported");
    expect_rejected(
        "STRING\nLAGRANGE 4\n",
        "a.fe:2: LAGRANGE is not supported; must be LINEAR (straight edges) or QUADRATIC (arcs)");
    expect_rejected("symmetry_group \"rotate\"",
                    "a.fe:1: the only symmetry group supported is \"torus\"");
    expect_rejected("PRESSURE 3",
                    "a.fe:1: PRESSURE makes the gas compressible, which is not "
                    "supported");
}

TEST(EvolverHeader, RejectsOtherTori) {
    expect_rejected(
        "periods\n1 0.5\n0 1",
        "a.fe:1: the first period must be along the x axis: its y component is 0.5, must be 0");
    expect_rejected("periods 1 0 0 -1",
                    "a.fe:1: the width and height of the torus must be positive, not 1 and -1");
    expect_rejected("periods 1 0 0 1e-5",
                    "a.fe:1: the width and the height of the torus must differ by at most the "
                    "factor 16384, but are 1 and 1e-05");
}

TEST(EvolverHeader, RejectsUnreadableStatements) {
    expect_rejected("", "a.fe:1: expected a section 'vertices', found the end of the file");
    expect_rejected("STRING\n12\n", "a.fe:2: expected a keyword of the top section, found '12'");
}

}  // namespace
}  // namespace foam::evolver
