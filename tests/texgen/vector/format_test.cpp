// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/format.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(VectorFormats, AreFoundByTheirSuffix) {
    EXPECT_EQ(find_vector_format("out/a.0001.svg")->name, "SVG");
    EXPECT_EQ(find_vector_format("a.json")->name, "JSON");
    EXPECT_EQ(find_vector_format("a.png"), nullptr);
    EXPECT_EQ(vector_suffixes(), ".svg, .dxf, .pdf, .csv, .json, .stl or .glb");
}

TEST(VectorFormats, EveryPartHasAMeaning) {
    for (const VectorFormat& format : vector_formats()) {
        for (const char* const map : {"albedo", "maze", "maze_solution", "contour"}) {
            const MapOptions maps;
            const VectorOptions drawing;
            const MeshOptions mesh;
            const VectorSettings settings{maps, drawing, mesh, {map}};
            for (const std::string& part : format.parts(settings)) {
                EXPECT_FALSE(meaning_of_part(part).empty()) << part;
            }
        }
    }
}

}  // namespace
}  // namespace foam::texgen
