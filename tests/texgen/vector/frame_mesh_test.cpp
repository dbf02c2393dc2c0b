// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/frame_mesh.h"

#include "tests/support/sample_foams.h"
#include "texgen/vector/appearance.h"
#include "texgen/vector/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

constexpr int kMeshPixels = 100;
constexpr double kMeshWidth = 80.0;

struct Subject {
    Frame frame;
    RasterGrid grid{kMeshPixels, kMeshPixels};
    FoamRecord record{};
    MapOptions maps{};
    VectorOptions drawing{.width_mm = kMeshWidth, .walls = VectorWalls::Outlines};
    MeshOptions mesh{};
    std::string map = "albedo";

    VectorSettings settings() const {
        return {maps, drawing, mesh, {map}, grid.width, grid.height};
    }
    Mesh solid() {
        FrameLayers layers({frame, record}, grid, 1);
        return frame_mesh({layers, settings(), "", ""});
    }
    // The area of the walls in the drawing, from its arcs, and the length of its outlines.
    std::pair<double, double> walls() {
        FrameLayers layers({frame, record}, grid, 1);
        const Drawing drawn = draw(layers, shown_content(drawing, {map}), maps, drawing);
        double area = 0.0;
        double length = 0.0;
        for (const Chain& chain : drawn.layers.back().shapes.front().chains) {
            area += signed_area(chain);
            for (const DrawnArc& arc : arcs_of(chain)) {
                length += arc_length(arc.arc());
            }
        }
        return {area, length};
    }
};

Subject torus() {
    Subject subject{test::fitted_frame(test::polydisperse_foam(60, 7), kMeshPixels, kMeshPixels)};
    subject.drawing.wall_width = 0.7;
    return subject;
}

Subject patch() {
    Subject subject{snapshot(test::patch_foam(40, 3), 1)};
    subject.grid.view = View{{0.0, 0.0}, 10.0};
    subject.drawing.wall_width = 0.7;
    return subject;
}

// Walls differ from their arcs by at most the tolerance along their outlines.
void expect_walls(Subject& subject, const Mesh& mesh) {
    const auto [area, length] = subject.walls();
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh),
                area * subject.mesh.wall_mm,
                length * subject.mesh.tolerance_mm * subject.mesh.wall_mm);
    // The polygons have two thirds of the tolerance as mean distance, some inside and some outside.
    EXPECT_NEAR(volume(mesh) / subject.mesh.wall_mm / area, 1.0, 0.02);
}

TEST(FrameMesh, KindFollowsTheFirstMap) {
    Subject subject = torus();
    EXPECT_EQ(shown_kind(subject.settings()), MeshKind::Relief);
    subject.map = "maze";
    EXPECT_EQ(shown_kind(subject.settings()), MeshKind::Walls);
    subject.mesh.kind = MeshKind::Relief;
    EXPECT_EQ(shown_kind(subject.settings()), MeshKind::Relief);
}

TEST(FrameMesh, WallsOfATorusAreCutAtTheTile) {
    Subject subject = torus();
    subject.mesh = {.kind = MeshKind::Walls, .base_mm = 0.0, .tolerance_mm = 0.005};
    const Mesh mesh = subject.solid();
    expect_walls(subject, mesh);
    float high = 0.0F;
    for (const Point3& point : mesh.positions) {
        EXPECT_GE(point[0], 0.0F);
        EXPECT_LE(point[0], static_cast<float>(kMeshWidth));
        high = std::max(high, point[2]);
    }
    EXPECT_EQ(high, 3.0F);
}

// The plate of a tile is the tile: 80 x 80 mm.
TEST(FrameMesh, ThePlateOfATileIsTheTile) {
    Subject subject = torus();
    subject.mesh = {.kind = MeshKind::Walls, .base_mm = 1.5, .tolerance_mm = 0.005};
    const Mesh with_plate = subject.solid();
    EXPECT_TRUE(is_closed(with_plate));
    subject.mesh.base_mm = 0.0;
    EXPECT_NEAR(volume(with_plate) - volume(subject.solid()), 1.5 * kMeshWidth * kMeshWidth, 0.05);
}

// Walls that cover the tile are a solid block, without and with a plate.
TEST(FrameMesh, WideWallsOfATileAreABlock) {
    Subject subject = torus();
    subject.drawing.wall_width = 2.0 * kMeshWidth;
    for (const double base : {0.0, 1.5}) {
        subject.mesh = {.kind = MeshKind::Walls, .base_mm = base};
        const Mesh mesh = subject.solid();
        EXPECT_TRUE(is_closed(mesh));
        const double height = base + subject.mesh.wall_mm;
        EXPECT_NEAR(volume(mesh), height * kMeshWidth * kMeshWidth, 1e-3);
    }
}

// Where a wall is cut at x = 0, it continues at x = 80, at the same height.
TEST(FrameMesh, TilesFitTogether) {
    Subject subject = torus();
    for (const MeshKind kind : {MeshKind::Walls, MeshKind::Relief}) {
        subject.mesh = {.kind = kind};
        std::map<float, std::vector<std::pair<float, float>>> borders;
        for (const Point3& point : subject.solid().positions) {
            if (point[0] == 0.0F || point[0] == static_cast<float>(kMeshWidth)) {
                borders[point[0]].emplace_back(point[1], point[2]);
            }
        }
        ASSERT_EQ(borders.size(), 2U);
        auto& left = borders.begin()->second;
        auto& right = borders.rbegin()->second;
        std::ranges::sort(left);
        std::ranges::sort(right);
        ASSERT_EQ(left.size(), right.size());
        ASSERT_GT(left.size(), 8U);
        for (std::size_t k = 0; k < left.size(); ++k) {
            EXPECT_NEAR(left[k].first, right[k].first, 1e-4);
            EXPECT_EQ(left[k].second, right[k].second);
        }
    }
}

TEST(FrameMesh, WholeBubblesAndPatchesHaveWallsAndAFullPlate) {
    for (Subject subject : {torus(), patch()}) {
        subject.drawing.wrap = VectorWrap::Whole;
        subject.mesh = {.kind = MeshKind::Walls, .base_mm = 0.0, .tolerance_mm = 0.005};
        expect_walls(subject, subject.solid());
        // The plate extends the outline by half a wall width and fills all bubbles.
        subject.mesh.base_mm = 2.0;
        const Mesh with_plate = subject.solid();
        EXPECT_TRUE(is_closed(with_plate));
        EXPECT_GT(volume(with_plate), 3.0 * subject.walls().first + 2.0 * 1000.0);
    }
}

// A maze of a patch has an entrance and an exit, so that its outer walls are not closed.
TEST(FrameMesh, AMazeOfAPatchStandsOnAPlate) {
    Subject subject = patch();
    subject.map = "maze_solution";
    EXPECT_TRUE(is_closed(subject.solid()));
}

// At the true scale, the volume above the base is the sum of the heights above the lowest one,
// times the area of a pixel: in the mean over the triangles, each point has the area of a pixel.
// The choice of diagonals changes that by less than a percent.
TEST(FrameMesh, AReliefAtTheTrueScaleHasTheVolumeOfItsHeights) {
    Subject subject = torus();
    subject.maps.relief.profile = ReliefProfile::Ridge;
    const Mesh mesh = subject.solid();
    EXPECT_TRUE(is_closed(mesh));
    FrameLayers layers({subject.frame, subject.record}, subject.grid, 1);
    FrameLayers measured = layers.on_grid(
        subject.grid, distance_needs(std::vector<std::string>{"height"}, subject.maps));
    const Image<float> heights =
        draw_height(measured, {subject.maps.relief, subject.maps.maze}, {}).pixels;
    const double low = *std::ranges::min_element(heights.samples());
    double sum = 0.0;
    for (const float height : heights.samples()) {
        sum += static_cast<double>(height) - low;
    }
    const double unit = height_unit(layers, subject.maps.relief) * kMeshWidth;
    const double pixel = kMeshWidth / kMeshPixels;
    const double expected = sum * unit * pixel * pixel;
    EXPECT_NEAR(volume(mesh) - 2.0 * kMeshWidth * kMeshWidth, expected, 0.01 * expected);
}

TEST(FrameMesh, AReliefHasTheGivenHeight) {
    for (Subject subject : {torus(), patch()}) {
        subject.mesh = {.base_mm = 3.0, .relief_mm = 4.0};
        const Mesh mesh = subject.solid();
        EXPECT_TRUE(is_closed(mesh));
        float low = 100.0F;
        float high = 0.0F;
        float right = 0.0F;
        for (const Point3& point : mesh.positions) {
            low = point[2] > 0.0F ? std::min(low, point[2]) : low;
            high = std::max(high, point[2]);
            right = std::max(right, point[0]);
        }
        EXPECT_EQ(low, 3.0F);
        EXPECT_EQ(high, 7.0F);
        EXPECT_EQ(right, static_cast<float>(kMeshWidth));
    }
}

std::string mesh_rejection(const Subject& subject) {
    try {
        check_mesh(subject.settings());
        return {};
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(FrameMesh, ImpossibleMeshesAreRejected) {
    Subject subject = torus();
    EXPECT_EQ(mesh_rejection(subject), "");
    subject.mesh.base_mm = 0.0;
    EXPECT_NE(mesh_rejection(subject).find("mesh.base_mm = 0"), std::string::npos);
    subject.mesh.base_mm = 1.0;
    subject.grid.width = subject.grid.height = 5000;
    EXPECT_NE(mesh_rejection(subject).find("image.size = [5000, 5000]"), std::string::npos);
    EXPECT_NE(mesh_rejection(subject).find("at most 20 million"), std::string::npos);
    subject.mesh.kind = MeshKind::Walls;
    EXPECT_EQ(mesh_rejection(subject), "");
    subject.drawing.wall_width = 0.0;
    subject.maps.albedo.film_width = 0.0;
    EXPECT_NE(mesh_rejection(subject).find("albedo.film_width is 0"), std::string::npos);
}

// With one level of pressure there are no contours.
TEST(FrameMesh, AFrameWithoutWallsIsRejected) {
    Subject subject = torus();
    subject.map = "contour";
    subject.maps.contour.levels = 1;
    EXPECT_THROW(subject.solid(), std::invalid_argument);
}

TEST(FrameMesh, TooManyTrianglesOfWallsAreRejected) {
    Subject subject = torus();
    subject.drawing.width_mm = 100'000.0;
    subject.drawing.wall_width = 1000.0;
    subject.mesh = {.kind = MeshKind::Walls, .tolerance_mm = 1e-9};
    EXPECT_THROW(subject.solid(), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
