// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_path.h"

#include "core/files/file_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace foam::texgen {
namespace {

// Returns the ends of all curves of a path, and its starts: "M1,2 3,4" for a line.
std::string ends_of(const BezierPath& path) {
    std::string text;
    const auto add = [&](const Vec2& point) {
        text +=
            std::to_string(std::lround(point.x())) + ',' + std::to_string(std::lround(point.y()));
    };
    for (const Subpath& part : path) {
        text += text.empty() ? "M" : " M";
        add(part.start);
        for (const CubicCurve& curve : part.curves) {
            text += ' ';
            add(curve.end);
        }
    }
    return text;
}

TEST(SvgPath, HasAbsoluteAndRelativeCommands) {
    EXPECT_EQ(ends_of(parse_svg_path("M1 2 L3,4 H5V6Z")), "M1,2 3,4 5,4 5,6 1,2");
    EXPECT_EQ(ends_of(parse_svg_path("m1 2l2,2h2v2z")), "M1,2 3,4 5,4 5,6 1,2");
    EXPECT_EQ(ends_of(parse_svg_path("M1 1 2 2-3 3m1 1 1 1")), "M1,1 2,2 -3,3 M-2,4 -1,5");
}

// After Z, a command continues at the start of the closed subpath, in a new subpath.
TEST(SvgPath, ContinuesAfterClosing) {
    EXPECT_EQ(ends_of(parse_svg_path("M1 1 h2 v2 z l5 0")), "M1,1 3,1 3,3 1,1 M1,1 6,1");
    EXPECT_EQ(ends_of(parse_svg_path("M1 1 h2 v2 z m5 0 h1")), "M1,1 3,1 3,3 1,1 M6,1 7,1");
}

TEST(SvgPath, ReadsNumbersWithoutSpaces) {
    EXPECT_EQ(ends_of(parse_svg_path("M.5.5-1-1")), ends_of(parse_svg_path("M 0.5 0.5 -1 -1")));
    EXPECT_EQ(ends_of(parse_svg_path("M1e1+2L3 4")), "M10,2 3,4");
    // Flags of arcs need no space: large = 0, positive = 1, end (20, 0).
    EXPECT_EQ(ends_of(parse_svg_path("M0 0a10 10 0 0120 0")), "M0,0 10,-10 20,0");
}

TEST(SvgPath, ContinuesCurvesSmoothly) {
    const BezierPath cubic = parse_svg_path("M0 0 C0 1 2 3 4 3 S 9 9 10 10");
    EXPECT_EQ(cubic[0].curves[1].control_1, Vec2(6.0, 3.0));
    const BezierPath corner = parse_svg_path("M0 0 L4 3 S 9 9 10 10");
    EXPECT_EQ(corner[0].curves[1].control_1, Vec2(4.0, 3.0));
    // A quadratic curve to (2, 0) with the control point (1, 3); T mirrors it to (3, -3).
    const BezierPath quadratic = parse_svg_path("M0 0 Q1 3 2 0 T4 0");
    EXPECT_NEAR(
        (quadratic[0].curves[1].control_1 - Vec2(2.0 + 2.0 / 3.0, -2.0)).norm(), 0.0, 1e-12);
}

// Points in the middle of the four kinds of arcs of radius 5 from (-4, 0) to (4, 0). Their centers
// are (0, 3) and (0, -3). y points down.
TEST(SvgPath, SelectsOneOfFourArcs) {
    const auto extreme = [](const char* flags) {
        const BezierPath path = parse_svg_path(std::string("M-4 0A5 5 0 ") + flags + " 4 0");
        double y = 0.0;
        for (const Vec2& corner : flattened(path[0], 1e-4)) {
            y = std::abs(corner.y()) > std::abs(y) ? corner.y() : y;
        }
        return y;
    };
    EXPECT_NEAR(extreme("0 0"), 2.0, 2e-3);
    EXPECT_NEAR(extreme("0 1"), -2.0, 2e-3);
    EXPECT_NEAR(extreme("1 0"), 8.0, 2e-3);
    EXPECT_NEAR(extreme("1 1"), -8.0, 2e-3);
}

// Radii that do not reach are enlarged: a half circle of radius 4.
TEST(SvgPath, EnlargesRadii) {
    const BezierPath path = parse_svg_path("M-4 0A1 1 0 0 1 4 0");
    for (const Vec2& corner : flattened(path[0], 1e-4)) {
        EXPECT_NEAR(corner.norm(), 4.0, 2e-3);
    }
}

std::string fault_of(const char* data) {
    try {
        parse_svg_path(data);
        return "none";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(SvgPath, SaysWhereDataAreMalformed) {
    EXPECT_EQ(fault_of(""), "none");
    EXPECT_EQ(fault_of("L1 2"), "the data of a path have an error at character 2");
    EXPECT_EQ(fault_of("M1"), "the data of a path have an error at character 3");
    EXPECT_EQ(fault_of("M1 2 L x 4"), "the data of a path have an error at character 8");
    for (const char* data : {"1 2",
                             "M1 2 Z 3",
                             "M1 2 B 3",
                             "M1 inf",
                             "M1 nan",
                             "M1 1e99",
                             "M--1 2",
                             "M0 0 A1 1 0 2 0 3 3",
                             "M+-1 2"}) {
        EXPECT_NE(fault_of(data), "none") << data;
    }
}

TEST(SvgTransform, MapsPoints) {
    const auto mapped_point = [](const char* text) {
        return parse_svg_transform(text)({2.0, 1.0});
    };
    const auto expect = [&](const char* text, double x, double y) {
        EXPECT_NEAR((mapped_point(text) - Vec2(x, y)).norm(), 0.0, 1e-12) << text;
    };
    expect("", 2, 1);
    expect("translate(3)", 5, 1);
    expect("translate(3, 4)", 5, 5);
    expect("scale(2)", 4, 2);
    expect("scale(2 -1)", 4, -1);
    expect("rotate(90)", -1, 2);
    expect("rotate(90 2 0)", 1, 0);
    expect("skewX(45)", 3, 1);
    expect("skewY(45)", 2, 3);
    expect("matrix(1 2 3 4 5 6)", 2 + 3 + 5, 4 + 4 + 6);
    expect("translate(1,0) scale(2)", 5, 2);  // the last one is applied first
    EXPECT_THROW(parse_svg_transform("scale(1 2 3)"), InputError);
    EXPECT_THROW(parse_svg_transform("turn(1)"), InputError);
    EXPECT_THROW(parse_svg_transform("scale(1"), InputError);
}

TEST(SvgPoints, AreAPolygon) {
    EXPECT_EQ(ends_of(parse_svg_points("1,2 3 4,5,6")), "M1,2 3,4 5,6");
    EXPECT_THROW(parse_svg_points("1 2 3"), InputError);
}

}  // namespace
}  // namespace foam::texgen
