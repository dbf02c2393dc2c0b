// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tables.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace foam::texgen {
namespace {

struct TablesOfFrame {
    Frame frame;
    RasterGrid grid{64, 64};
    FoamRecord record{};
    AlbedoOptions options{};

    nlohmann::json json() {
        const FrameLayers layers({frame, record}, grid, 1);
        return nlohmann::json::parse(to_json(layers, options));
    }
    std::string csv(const char* table) {
        const FrameLayers layers({frame, record}, grid, 1);
        return to_csv(layers, options, table);
    }
};

TEST(Tables, AreasFollowFromTheArcsOfTheFilms) {
    TablesOfFrame subject{test::fitted_frame(test::polydisperse_foam(40, 2), 64, 64)};
    const nlohmann::json json = subject.json();
    EXPECT_EQ(json["bubbles"].size(), 40U);
    EXPECT_EQ(json["films"].size(), 120U);     // 3 per bubble
    EXPECT_EQ(json["junctions"].size(), 80U);  // 2 per bubble
    // The area of a torus is the sum of all areas, and the pressure difference of a film is the
    // tension times its curvature.
    double area = 0.0;
    std::vector<double> pressures(json["bubbles"].size());
    for (const auto& bubble : json["bubbles"]) {
        area += bubble["area"].get<double>();
        pressures.at(bubble["bubble"].get<std::size_t>()) = bubble["pressure"].get<double>();
    }
    EXPECT_NEAR(
        area, json["domain"]["width"].get<double>() * json["domain"]["height"].get<double>(), 1e-9);
    for (const auto& film : json["films"]) {
        const double difference = pressures.at(film["left"].get<std::size_t>()) -
                                  pressures.at(film["right"].get<std::size_t>());
        EXPECT_NEAR(
            json["film_tension"].get<double>() * film["curvature"].get<double>(), difference, 1e-6);
    }
}

TEST(Tables, FilmsLeadFromTheirTailToACopyOfTheirHead) {
    TablesOfFrame subject{test::fitted_frame(test::polydisperse_foam(40, 2), 64, 64)};
    const nlohmann::json json = subject.json();
    const double width = json["domain"]["width"].get<double>();
    for (const auto& film : json["films"]) {
        const auto& head = json["junctions"][film["head"].get<std::size_t>()];
        const double x = film["x"].get<double>() + film["chord_x"].get<double>();
        const double periods = (x - head["x"].get<double>()) / width;
        EXPECT_NEAR(periods, std::round(periods), 1e-12);
    }
}

TEST(Tables, TheOutsideOfAPatchHasNoBubble) {
    Foam foam = test::patch_foam(8, 5);
    foam.lone_bubbles.push_back({foam.next_identity, {20.0, 1.0}, 3.0});
    TablesOfFrame subject{snapshot(foam, 1), {64, 64, 0, 0, View{{0.0, 0.0}, 4.0}}};
    const nlohmann::json json = subject.json();
    EXPECT_TRUE(json["domain"].is_null());
    const auto outer = std::ranges::count_if(json["films"], [](const auto& film) {
        return film["left"].is_null() || film["right"].is_null();
    });
    EXPECT_GT(outer, 2);
    const auto& lone = json["bubbles"].back();
    EXPECT_EQ(lone["sides"], 0);
    EXPECT_NEAR(lone["x"].get<double>(), 20.0, 1e-12);
    EXPECT_NE(subject.csv("films").find(",\n"), std::string::npos);  // an empty last cell
}

// A honeycomb of 4 x 4 hexagons.
TEST(Tables, CsvHasALinePerRow) {
    TablesOfFrame subject{test::fitted_frame(honeycomb(4, 4), 64, 64)};
    const std::string bubbles = subject.csv("bubbles");
    EXPECT_EQ(std::ranges::count(bubbles, '\n'), 17);
    EXPECT_TRUE(bubbles.starts_with("bubble,x,y,area,target_area,pressure,sides,color\n0,"));
    EXPECT_EQ(std::ranges::count(subject.csv("films"), '\n'), 49);
    EXPECT_EQ(std::ranges::count(subject.csv("junctions"), '\n'), 33);
}

}  // namespace
}  // namespace foam::texgen
