// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/outline_file.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Outlines = std::vector<foam::Outline>;

Outlines outlines(const std::string& elements) {
    return outlines_of_svg("<svg xmlns='http://www.w3.org/2000/svg'>" + elements + "</svg>");
}

double total_area(const Outlines& parts) {
    double area = 0.0;
    for (const foam::Outline& part : parts) {
        area += outline_area(part);
    }
    return area;
}

// Returns the area of the outline as a fraction of its bounding box.
double filled_fraction(const Outlines& parts) {
    Vec2 low = parts.front().outer.front();
    Vec2 high = low;
    for (const foam::Outline& part : parts) {
        for (const Vec2& corner : part.outer) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    }
    return total_area(parts) / (high - low).prod();
}

constexpr double kRounding = 2e-3;  // of the picture from which outlines are traced

TEST(OutlineFile, ReadsBasicShapes) {
    const double disc = std::numbers::pi / 4.0;
    EXPECT_NEAR(filled_fraction(outlines("<rect width='30' height='20'/>")), 1.0, kRounding);
    EXPECT_NEAR(filled_fraction(outlines("<circle cx='5' cy='5' r='10'/>")), disc, kRounding);
    EXPECT_NEAR(filled_fraction(outlines("<ellipse rx='9mm' ry='2mm'/>")), disc, kRounding);
    EXPECT_NEAR(filled_fraction(outlines("<polygon points='0,0 4,0 0,4'/>")), 0.5, kRounding);
    EXPECT_NEAR(filled_fraction(outlines("<path d='M0 0 H10 V10'/>")), 0.5, kRounding);
    // Four corners of radius 5 of a square of 20: 400 - 4 (25 - 25 pi / 4) = 400 - 100 + 25 pi.
    EXPECT_NEAR(filled_fraction(outlines("<rect width='20' height='20' rx='5'/>")),
                0.75 + 25.0 * std::numbers::pi / 400.0,
                kRounding);
}

TEST(OutlineFile, AppliesTransformsOfGroups) {
    // A square, sheared to a parallelogram that is twice as wide as its base.
    EXPECT_NEAR(filled_fraction(outlines("<g transform='skewX(45)'><rect width='1' height='1' "
                                         "transform='scale(10)'/></g>")),
                0.5,
                kRounding);
}

// y points down in an SVG and up in an outline: the right angle of this triangle is at the top.
TEST(OutlineFile, PointsUp) {
    const Outlines triangle = outlines("<path d='M0 0 H10 L0 10 Z'/>");
    Vec2 center = outline_centroid(triangle[0]);
    double top = center.y();
    double bottom = center.y();
    for (const Vec2& corner : triangle[0].outer) {
        top = std::max(top, corner.y());
        bottom = std::min(bottom, corner.y());
    }
    EXPECT_NEAR((top - center.y()) / (top - bottom), 1.0 / 3.0, kRounding);
}

TEST(OutlineFile, FindsPartsAndHoles) {
    const Outlines parts = outlines(
        "<path d='M0 0 h30 v30 h-30 z M10 10 v10 h10 v-10 z'/>"
        "<rect x='40' width='10' height='10'/>");
    ASSERT_EQ(parts.size(), 2U);
    ASSERT_EQ(parts[0].holes.size(), 1U);
    EXPECT_TRUE(parts[1].holes.empty());
    EXPECT_NEAR(outline_area(parts[0]) / outline_area(parts[1]), 8.0, 8.0 * kRounding);
    EXPECT_FALSE(is_inside(parts[0], outline_centroid(parts[0])));
}

// A ring around a disc around nothing: the disc is a part of its own, not a hole of the ring.
TEST(OutlineFile, FindsPartsWithinHoles) {
    const Outlines parts = outlines(
        "<g fill-rule='evenodd'><path d='M0 0 h50 v50 h-50 z M10 10 h30 v30 "
        "h-30 z M20 20 h10 v10 h-10 z'/></g>");
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].holes.size(), 1U);
    EXPECT_TRUE(parts[1].holes.empty());
}

TEST(OutlineFile, UnitesOverlappingShapes) {
    const Outlines parts =
        outlines("<rect width='20' height='10'/><rect x='10' width='20' height='10'/>");
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(filled_fraction(parts), 1.0, kRounding);
}

TEST(OutlineFile, SkipsWhatIsNotFilled) {
    const std::string square = "<rect width='10' height='10'/>";
    for (const char* skipped :
         {"<rect x='20' width='10' height='10' fill='none'/>",
          "<rect x='20' width='10' height='10' style='stroke:red; fill: none'/>",
          "<g display='none'><rect x='20' width='10' height='10'/></g>",
          "<g visibility='hidden'><rect x='20' width='10' height='10'/></g>",
          "<rect x='20' width='10' height='10' opacity='0.0'/>",
          "<g style='opacity: 0%'><rect x='20' width='10' height='10'/></g>",
          "<g fill='none'><rect x='20' width='10' height='10' fill='inherit'/></g>",
          "<g visibility='hidden'><rect x='20' width='10' height='10' "
          "style='visibility:inherit'/></g>",
          "<svg width='0' height='10'><rect x='20' width='10' height='10'/></svg>",
          "<defs><rect x='20' width='10' height='10'/></defs>",
          "<clipPath><rect x='20' width='10' height='10'/></clipPath>",
          "<line x1='20' x2='30'/>",
          // Lengths of elements that are not drawn may have any unit.
          "<radialGradient id='g' cx='50%' cy='50%' r='50%'/>",
          "<rect width='100%' height='100%' fill='none'/>",
          "<circle r='50%' visibility='hidden'/>"}) {
        EXPECT_EQ(outlines(square + skipped).size(), 1U) << skipped;
    }
}

TEST(OutlineFile, FollowsUses) {
    const char* const symbol = "<symbol id='s'><rect width='10' height='10'/></symbol>";
    EXPECT_EQ(
        outlines(symbol + std::string("<use href='#s'/><use xlink:href='#s' x='20'/>")).size(), 2U);
    EXPECT_THROW(outlines("<use href='#missing'/>"), InputError);
    EXPECT_THROW(outlines("<g id='a'><use href='#a'/><use href='#a'/></g>"), InputError);
}

TEST(OutlineFile, InheritsProperties) {
    EXPECT_EQ(
        outlines("<rect width='9' height='9' visibility='inherit' opacity='inherit'/>").size(), 1U);
    EXPECT_EQ(outlines("<rect width='9' height='9' opacity='0.01'/>").size(), 1U);
    // By the even-odd rule, the square has a hole.
    const Outlines square = outlines(
        "<g fill-rule='evenodd'><path fill-rule='inherit' d='M0 0 h30 v30 h-30 z M10 10 h10 "
        "v10 h-10 z'/></g>");
    EXPECT_EQ(square.at(0).holes.size(), 1U);
}

// Both icons are scaled from 10 x 10 to 40 x 40, so that the left one touches the right one and is
// as large as it.
TEST(OutlineFile, ScalesTheContentOfViewports) {
    const std::string right = "<rect x='40' width='40' height='40'/>";
    const std::string icon = "viewBox='100 0 10 10'><rect x='100' width='10' height='10'/>";
    for (const std::string& left :
         {"<svg width='40' height='40' " + icon + "</svg>",
          "<symbol id='s' " + icon + "</symbol><use href='#s' width='40' height='40'/>",
          "<svg id='s' x='-90' width='7' height='7' " + icon +
              "</svg><use href='#s' x='90' width='40' height='40'/>",
          "<svg width='80' height='40' preserveAspectRatio='xMinYMin' " + icon + "</svg>",
          "<svg width='40' height='20' preserveAspectRatio='xMinYMin slice' " + icon + "</svg>"}) {
        const Outlines parts = outlines(left + right);
        ASSERT_EQ(parts.size(), left.find("<svg id") == 0 ? 2U : 1U) << left;
        EXPECT_NEAR(filled_fraction({parts.front()}), 1.0, kRounding) << left;
    }
}

// Without a size, a viewport is as large as the one around it, here 20 x 10. The position 25% is 5.
TEST(OutlineFile, ViewportsAreFractionsOfTheOneAround) {
    const Outlines half = outlines_of_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 10'><svg viewBox='0 0 2 1'>"
        "<rect width='2' height='1'/></svg><svg x='25%' y='10' width='50%' viewBox='0 0 1 1'>"
        "<rect width='1' height='1'/></svg></svg>");
    // A rectangle of 20 x 10 and, below its center, a square of 10 x 10: 300 of 20 x 20.
    ASSERT_EQ(half.size(), 1U);
    EXPECT_NEAR(filled_fraction(half), 0.75, kRounding);
}

// The speck has 1/1600 of the area of the square, the dot has 1/100.
TEST(OutlineFile, DropsSpecks) {
    const std::string square = "<rect width='40' height='40'/>";
    EXPECT_EQ(outlines(square + "<rect x='50' width='1' height='1'/>").size(), 1U);
    EXPECT_EQ(outlines(square + "<rect x='50' width='4' height='4'/>").size(), 2U);
}

std::string fault_of(const std::string& document) {
    try {
        outlines_of_svg(document);
        return "none";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(OutlineFile, SaysWhatIsWrongWithADrawing) {
    EXPECT_EQ(fault_of("<svg/>"), "it has no filled shape");
    EXPECT_EQ(fault_of("<svg><rect width='10' height='0'/></svg>"), "it has no filled shape");
    EXPECT_EQ(fault_of("<svg><path d='M0 0 L10 10'/></svg>"), "it has no filled shape");
    EXPECT_EQ(fault_of("<html/>"), "it is XML, but no SVG");
    EXPECT_EQ(
        fault_of("<svg><text>a</text></svg>"),
        "text has no outline; convert it to paths (in Inkscape: Path > Object to Path), or remove "
        "it");
    EXPECT_EQ(fault_of("<svg><rect width='100%' height='3'/></svg>"),
              "width=\"100%\" of a <rect> is no length in px, mm, cm, in, pt or pc");
    EXPECT_EQ(fault_of("<svg><rect width='1e9' height='3' transform='scale(1e9)'/></svg>"),
              "its coordinates are too large");
    EXPECT_EQ(fault_of("<svg").substr(0, 23), "it is not valid XML: Er");
    std::string deep;
    for (int k = 0; k < 100; ++k) {
        deep += "<g>";
    }
    for (int k = 0; k < 100; ++k) {
        deep += "</g>";
    }
    EXPECT_EQ(fault_of("<svg>" + deep + "</svg>"),
              "its elements are nested too deeply, or are too many");
    std::string subpaths;
    std::string uses;
    for (int k = 0; k < 400; ++k) {
        subpaths += "M0 0 ";
        uses += "<use href='#a'/>";
    }
    EXPECT_EQ(fault_of("<svg><path id='a' d='" + subpaths + "'/>" + uses + "</svg>"),
              "it has more than 100000 lines, curves and subpaths");
}

TEST(OutlineFile, NamesTheFile) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.svg").string();
    const std::string text = "<svg/>";
    write_file(path, std::as_bytes(std::span(text)));
    try {
        read_outline_file(path);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), "cannot use '" + path + "' as an outline: it has no filled shape");
    }
}

// A picture of 40 x 20 pixels: a black square of 10 x 10 pixels on white.
TEST(OutlineFile, TracesTheDarkPartOfAPicture) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.png").string();
    Image<std::uint8_t> image(40, 20, 1);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool is_dark = x >= 5 && x < 15 && y >= 5 && y < 15;
            image.pixel(x, y)[0] = is_dark ? 0 : 255;
        }
    }
    write_file(path, encode_png(image.view()));
    const Outlines parts = read_outline_file(path).parts;
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(outline_area(parts[0]), 100.0, 1.0);
}

TEST(OutlineFile, HashesTheContentOfADrawing) {
    const TemporaryFolder folder;
    const auto hash_of = [&](const std::string& name, const std::string& text) {
        write_file(folder.path() / name, std::as_bytes(std::span(text)));
        return read_outline_file((folder.path() / name).string()).hash;
    };
    const std::string hash = hash_of("a.svg", "<svg><rect width='1' height='1'/></svg>");
    EXPECT_EQ(hash_of("b.svg", "<svg><rect width='1' height='1'/></svg>"), hash);
    EXPECT_NE(hash_of("a.svg", "<svg><rect width='1' height='2'/></svg>"), hash);
}

TEST(OutlineFile, RejectsAPictureWithoutADarkPart) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.png").string();
    Image<std::uint8_t> image(4, 4, 1);
    std::ranges::fill(image.samples(), 255);
    write_file(path, encode_png(image.view()));
    EXPECT_THROW(read_outline_file(path), InputError);
}

}  // namespace
}  // namespace foam::texgen
