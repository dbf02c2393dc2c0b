#include "texgen/raster/cell_mask.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// Rows from the top, as one reads.
std::string picture(const CellMask& mask) {
    std::string text;
    for (int row = mask.rows() - 1; row >= 0; --row) {
        for (int x = 0; x < mask.columns(); ++x) {
            text += ((mask.sixteen(x / 16, row) >> (x % 16)) & 1) != 0 ? '#' : '.';
        }
        text += '\n';
    }
    return text;
}

std::vector<SubpixelPoint> in_pixels(std::vector<SubpixelPoint> points) {
    for (SubpixelPoint& point : points) {
        point = {point.x * kSubpixel, point.y * kSubpixel};
    }
    return points;
}

TEST(CellMask, HoldsThePixelsWhoseCentresAreWithin) {
    CellMask mask;
    mask.reset(6, 4);
    mask.fill(in_pixels({{0, 0}, {6, 0}, {0, 4}}), {});
    // The edge is at x = 6 - 1.5 y: 0.75, 2.25, 3.75, 5.25 at the middles of the rows.
    EXPECT_EQ(picture(mask), "#.....\n##....\n####..\n#####.\n");
}

// A square from centre to centre has the centres on its left and lower edges.
TEST(CellMask, GivesEdgesToTheRight) {
    constexpr std::int32_t kHalf = kSubpixel / 2;
    const std::vector<SubpixelPoint> square{{kHalf, kHalf},
                                            {kHalf + 2 * kSubpixel, kHalf},
                                            {kHalf + 2 * kSubpixel, kHalf + 2 * kSubpixel},
                                            {kHalf, kHalf + 2 * kSubpixel}};
    CellMask mask;
    mask.reset(4, 4);
    mask.fill(square, {});
    EXPECT_EQ(picture(mask), "....\n....\n##..\n##..\n");
}

TEST(CellMask, CutsOffWhatIsOutside) {
    CellMask mask;
    mask.reset(5, 3, 1);
    mask.fill(in_pixels({{-9, -9}, {3, -9}, {3, 9}, {-9, 9}}), {});
    EXPECT_EQ(picture(mask), "###..\n###..\n.....\n");
    mask.reset(2, 2);
    mask.fill(in_pixels({{-9, -9}, {90, -9}, {90, 9}, {-9, 9}}), {});
    EXPECT_EQ(picture(mask), "##\n##\n");
}

// The bits of a row span several words.
TEST(CellMask, GoesOnFromWordToWord) {
    for (const auto& [begin, end] : {std::pair{0, 200}, {3, 64}, {64, 128}, {63, 65}, {199, 200}}) {
        CellMask mask;
        mask.reset(200, 1);
        mask.fill(in_pixels({{begin, 0}, {end, 0}, {end, 1}, {begin, 1}}), {});
        std::string row(200, '.');
        row.replace(static_cast<std::size_t>(begin),
                    static_cast<std::size_t>(end - begin),
                    static_cast<std::size_t>(end - begin),
                    '#');
        EXPECT_EQ(picture(mask), row + '\n');
        std::string runs;
        mask.for_each_run(0, [&](int from, int to) {
            runs += std::to_string(from) + "-" + std::to_string(to) + " ";
        });
        EXPECT_EQ(runs, std::to_string(begin) + "-" + std::to_string(end) + " ");
    }
}

}  // namespace
}  // namespace foam::texgen
