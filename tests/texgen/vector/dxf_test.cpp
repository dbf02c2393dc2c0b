// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/dxf.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

using Groups = std::vector<std::pair<int, std::string>>;

Groups groups_of(const std::string& text) {
    Groups groups;
    std::istringstream stream(text);
    std::string code;
    std::string value;
    while (std::getline(stream, code) && std::getline(stream, value)) {
        groups.emplace_back(std::stoi(code), value);
    }
    return groups;
}

// Returns the values of a code in all entities of a type.
std::vector<double> values_of(const Groups& groups, const std::string& type, int code) {
    std::vector<double> values;
    bool inside = false;
    for (const auto& [key, value] : groups) {
        inside = key == 0 ? value == type : inside;
        if (inside && key == code) {
            values.push_back(std::stod(value));
        }
    }
    return values;
}

// A quarter of a circle has the bulge tan(pi / 8) = sqrt(2) - 1.
Drawing quarter_circle() {
    Drawing drawing{.width = 4.0, .height = 3.0};
    drawing.layers.push_back(
        {.name = "films",
         .shapes = {{.kind = "film",
                     .chains = {{{1.0, 0.0}, {{{0.0, 1.0}, 0.25 * std::numbers::pi}}, false}}}},
         .is_tool_path = true});
    drawing.layers.push_back(
        {.name = "bubbles", .shapes = {{.kind = "bubble", .chains = {circle({1.0, 1.0}, 1.0)}}}});
    drawing.junctions = {{2.0, 2.5}};
    return drawing;
}

TEST(Dxf, AChainIsAPolylineWithBulges) {
    const Groups groups = groups_of(to_dxf(quarter_circle()));
    const std::vector<double> bulges = values_of(groups, "LWPOLYLINE", 42);
    ASSERT_EQ(bulges.size(), 1U);
    EXPECT_NEAR(bulges[0], std::numbers::sqrt2 - 1.0, 1e-15);
    EXPECT_EQ(values_of(groups, "LWPOLYLINE", 10), (std::vector<double>{1.0, 0.0}));
    EXPECT_EQ(values_of(groups, "LWPOLYLINE", 90), (std::vector<double>{2.0}));
    EXPECT_EQ(values_of(groups, "LWPOLYLINE", 70), (std::vector<double>{0.0}));
}

TEST(Dxf, AClosedChainRepeatsNoVertex) {
    Drawing drawing = quarter_circle();
    drawing.layers[0].shapes[0].chains = {circle({1.0, 1.0}, 1.0)};
    const Groups groups = groups_of(to_dxf(drawing));
    EXPECT_EQ(values_of(groups, "LWPOLYLINE", 90), (std::vector<double>{2.0}));
    EXPECT_EQ(values_of(groups, "LWPOLYLINE", 70), (std::vector<double>{1.0}));
    const std::vector<double> bulges = values_of(groups, "LWPOLYLINE", 42);
    ASSERT_EQ(bulges.size(), 2U);  // half a circle has the bulge 1
    EXPECT_NEAR(bulges[0], 1.0, 1e-15);
}

TEST(Dxf, JunctionsArePointsAndTheUnitIsMillimeters) {
    const Groups groups = groups_of(to_dxf(quarter_circle()));
    EXPECT_EQ(values_of(groups, "POINT", 20), (std::vector<double>{2.5}));
    bool found = false;
    for (std::size_t k = 0; k + 1 < groups.size(); ++k) {
        found = found || (groups[k].second == "$INSUNITS" && std::stoi(groups[k + 1].second) == 4);
    }
    EXPECT_TRUE(found);
    EXPECT_EQ(groups.back().second, "EOF");
}

}  // namespace
}  // namespace foam::texgen
