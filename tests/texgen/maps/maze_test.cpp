// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze.h"

#include "tests/support/sample_foams.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/maze_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 512;  // pixels

// A frame of a patch, in the middle of a square image.
struct PatchPicture {
    Frame frame = snapshot(foam::test::patch_foam(40, 5), 1);
    FoamRecord record;
    FrameLayers layers{
        {frame, record, nullptr, {}}, {kSide, kSide, 0, 0, View{{0.0, 0.0}, 0.1 * kSide}}, 1};
};

// Writes a PGM of 16 bits whose top row is the last row of pixels. `value` returns the value of a
// pixel.
template <class Value>
void write_pgm(const std::filesystem::path& path, int largest, const Value& value) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << kSide << ' ' << kSide << '\n' << largest << '\n';
    for (int y = kSide - 1; y >= 0; --y) {
        for (int x = 0; x < kSide; ++x) {
            const auto one = static_cast<unsigned>(value(x, y));
            if (largest > 255) {
                file.put(static_cast<char>(one / 256));
            }
            file.put(static_cast<char>(one % 256));
        }
    }
}

// Returns the identities of the bubbles that the way visits.
std::vector<BubbleIdentity> bubbles_on(const Frame& frame, const std::vector<HalfEdgeId>& way) {
    std::vector<BubbleIdentity> bubbles;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        bubbles.push_back(frame.bubbles[frame.network.right(way[k])].identity);
    }
    return bubbles;
}

// A program that sees only the pictures finds two walls, two gaps, and the way between the gaps.
TEST(Maze, IsSolvedFromThePictureAlone) {
    PatchPicture picture;
    const ColorPixels maze =
        draw_maze(picture.layers, {.wall_color = "#000000", .passage_color = "#ffffff"});
    const TemporaryFolder folder;
    const std::filesystem::path tones = folder.path() / "maze.pgm";
    const std::filesystem::path ids = folder.path() / "ids.pgm";
    write_pgm(tones, 255, [&](int x, int y) {
        const auto pixel = maze.pixels.pixel(x, y);
        const double shade = (1.0 - pixel[0] / kWhite) * pixel[3] / kWhite;
        return std::lround(255.0 * (1.0 - shade));
    });
    const DistanceField& field = picture.layers.distance();
    write_pgm(ids, 65535, [&](int x, int y) {
        const std::uint32_t id = field.ids.pixel(x, y)[0];
        return picture.layers.is_surroundings(id)
                   ? BubbleIdentity{0}
                   : picture.frame.bubbles[id_at<BubbleId>(id)].identity + 1;
    });
    const std::filesystem::path output = folder.path() / "way.txt";
    const std::string script =
        (foam::test::data_folder() / "../texgen/maps/solve_maze.py").string();
    const auto code = run_external({"sh",
                                    "-c",
                                    "exec python3 \"$0\" \"$1\" \"$2\" > \"$3\"",
                                    script,
                                    tones.string(),
                                    ids.string(),
                                    output.string()},
                                   {.folder = {}, .shows_errors = true});
    ASSERT_EQ(code.value_or(-1), 0);
    std::ifstream file(output);
    std::vector<BubbleIdentity> way;
    for (BubbleIdentity bubble = 0; file >> bubble;) {
        way.push_back(bubble);
    }
    const std::vector<BubbleIdentity> expected =
        bubbles_on(picture.frame, find_maze(picture.frame, maze_rule({})).solution);
    std::vector<BubbleIdentity> backwards(expected.rbegin(), expected.rend());
    EXPECT_GT(way.size(), 5U);
    EXPECT_THAT(way, testing::AnyOf(expected, backwards));
}

// Pixels of walls keep their color.
TEST(Maze, TheSolutionChangesThePassagesOnly) {
    PatchPicture picture;
    const MazeOptions options{.wall_color = "#000000",
                              .passage_color = "#ffffff",
                              .solution_width = 0.05,
                              .solution_color = "#ff0000"};
    const ColorPixels without = draw_maze(picture.layers, options);
    const ColorPixels with = draw_maze_solution(picture.layers, options);
    int changed = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto before = without.pixels.pixel(x, y);
            if (before[3] > 0 && before[0] < 1000) {
                EXPECT_EQ(with.pixels.pixel(x, y)[0], before[0]) << x << ", " << y;
            }
            changed += with.pixels.pixel(x, y)[1] != before[1] ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 1000);
}

// A lone bubble is a room of its own: a wall along its circle.
TEST(Maze, ALoneBubbleHasAWall) {
    test::LoneCircle circle(20.0);
    const ColorPixels maze = draw_maze(
        circle.layers, {.wall_width = 0.2, .wall_color = "#000000", .passage_color = "#ffffff"});
    EXPECT_EQ(maze.pixels.pixel(32, 32)[0], 65535);
    EXPECT_EQ(maze.pixels.pixel(32 + 20, 32)[0], 0);
    EXPECT_EQ(maze.pixels.pixel(32, 31 - 20)[0], 0);
    EXPECT_EQ(maze.pixels.pixel(32, 60)[3], 0);
}

TEST(Maze, LimitsHoldOnBothSides) {
    test::expect_limits(maze_keys(),
                        {{"chance", "-0.1", "0", "1", "1.1"},
                         {"loops", "-0.1", "0", "1", "1.1"},
                         {"seed", "-1", "0", "9223372036854775807", "1.5"},
                         {"wall_width", "-1", "0", "10", "11"},
                         {"solution_width", "-1", "0", "10", "11"}});
}

}  // namespace
}  // namespace foam::texgen
