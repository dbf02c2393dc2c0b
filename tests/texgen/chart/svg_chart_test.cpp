#include "texgen/chart/svg_chart.h"

#include "tests/texgen/chart/well_formed.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <string>

namespace foam::texgen {
namespace {

using test::is_well_formed;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

Chart small_chart() {
    return {"Areas & <angles>",
            {"time (s)"},
            {"area", AxisKind::Logarithmic},
            {{"between", 2.0, 5.0, {0xd3, 0xec, 0xe2}}},
            {{"\"line\"", Mark::Line, {1, 2, 3}, {{0.0, 1.0}, {10.0, 100.0}}},
             {"", Mark::Discs, {0, 0, 255}, {{5.0, 10.0}, {2.5, 10.0}}},
             {"empty", Mark::Diamonds, {255, 0, 0}, {}}}};
}

TEST(WellFormed, FindsFaults) {
    EXPECT_TRUE(is_well_formed("<a b=\"1\"><c/>x &lt; y</a>\n"));
    for (const char* faulty :
         {"<a>", "<a></b>", "</a>", "<a/><b/>", "<a b=1/>", "<a>&</a>", "<a b=\"<\"/>", "x<a/>"}) {
        EXPECT_FALSE(is_well_formed(faulty)) << faulty;
    }
}

TEST(SvgChart, IsWellFormedAndKeepsTheText) {
    const std::string svg = to_svg(small_chart());
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(svg.find("<svg xmlns=\"http://www.w3.org/2000/svg\""), 0U);
    EXPECT_NE(svg.find("<title>Areas &amp; &lt;angles&gt;</title>"), std::string::npos);
    for (const char* text : {">time (s)</text>", ">area</text>", ">&quot;line&quot;</text>"}) {
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    }
}

// The plot reaches from (80, 340) to (560, 40). x goes from 0 to 10 and y over the two decades from
// 1 to 100: (5, 10) lies in the middle, at (320, 190).
TEST(SvgChart, PutsPointsWhereTheirValuesAre) {
    const std::string svg = to_svg(small_chart());
    EXPECT_NE(svg.find("points=\"80.00,340.00 560.00,40.00\""), std::string::npos);
    EXPECT_NE(svg.find("cx=\"320.00\" cy=\"190.00\""), std::string::npos);
    EXPECT_NE(svg.find("cx=\"200.00\" cy=\"190.00\""), std::string::npos);
    EXPECT_NE(svg.find("stroke=\"#010203\""), std::string::npos);
}

// y = 2 lies log10(2)/2 of 300 above the bottom, at 294.85; y = 5 at 340 - 150 log10(5) = 235.15.
TEST(SvgChart, BandsReachAcrossThePlot) {
    EXPECT_NE(to_svg(small_chart())
                  .find("<rect x=\"80.00\" y=\"235.15\" width=\"480.00\" height=\"59.69\" "
                        "fill=\"#d3ece2\"/>"),
              std::string::npos);
}

TEST(SvgChart, TheLegendNamesBandsAndSeriesWithANameOnly) {
    const std::string svg = to_svg(small_chart());
    EXPECT_EQ(count(svg, "x=\"614.00\""), 3U);  // "line", empty, between
    Chart nameless = small_chart();
    nameless.bands.clear();
    nameless.series = {{"", Mark::Line, {}, {{0.0, 1.0}}}};
    EXPECT_EQ(count(to_svg(nameless), "x=\"614.00\""), 0U);
    EXPECT_NE(to_svg(nameless).find(" width=\"580\""), std::string::npos);
}

TEST(SvgChart, LeavesOutWhatCannotBeShown) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Chart chart = small_chart();
    chart.series = {{"odd",
                     Mark::Discs,
                     {},
                     {{1.0, 1.0}, {kNan, 1.0}, {1.0, kInfinity}, {1.0, 0.0}, {1.0, -3.0}}}};
    const std::string svg = to_svg(chart);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(count(svg, "<circle"), 2U);  // one point and its sample in the legend
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgChart, AnEmptyChartHasAxes) {
    const std::string svg = to_svg({"none", {"x"}, {"y", AxisKind::Logarithmic}, {}, {}});
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_NE(svg.find(">0.0</text>"), std::string::npos);
    EXPECT_NE(svg.find(">10</text>"), std::string::npos);
}

TEST(SvgChart, EveryMarkIsDrawn) {
    Chart chart = small_chart();
    chart.series.clear();
    for (const Mark mark :
         {Mark::Line, Mark::DashedLine, Mark::Discs, Mark::Circles, Mark::Diamonds}) {
        chart.series.push_back({"", mark, {}, {{0.0, 1.0}, {1.0, 2.0}, {2.0, 2.0}}});
    }
    const std::string svg = to_svg(chart);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(count(svg, "<polyline"), 2U);
    EXPECT_EQ(count(svg, "stroke-dasharray"), 1U);
    EXPECT_EQ(count(svg, "<circle"), 6U);
    EXPECT_EQ(count(svg, "<path"), 3U);
}

}  // namespace
}  // namespace foam::texgen
