#include "texgen/stats/line_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam::texgen {
namespace {

TEST(LineFit, FindsTheLineOfPointsOnIt) {
    const std::vector<ChartPoint> points{{100.0, 3.0}, {101.0, 3.5}, {104.0, 5.0}};
    const LineFit fit = fit_line(points);
    EXPECT_NEAR(fit.slope, 0.5, 1e-13);
    EXPECT_NEAR(fit.intercept, -47.0, 1e-11);
    EXPECT_NEAR(fit.at(102.0), 4.0, 1e-12);
    EXPECT_NEAR(fit.determination, 1.0, 1e-13);
}

// Means 1 and 1; sums of products about them: xx = 2, xy = 1, yy = 2. So the slope is 1/2, the
// intercept 1/2, and R squared 1/4.
TEST(LineFit, IsLeastSquares) {
    const std::vector<ChartPoint> points{{0.0, 0.0}, {1.0, 2.0}, {2.0, 1.0}};
    const LineFit fit = fit_line(points);
    EXPECT_NEAR(fit.slope, 0.5, 1e-15);
    EXPECT_NEAR(fit.intercept, 0.5, 1e-15);
    EXPECT_NEAR(fit.determination, 0.25, 1e-15);
}

TEST(LineFit, ALevelLineExplainsAll) {
    const std::vector<ChartPoint> points{{0.0, 2.0}, {1.0, 2.0}};
    EXPECT_EQ(fit_line(points).slope, 0.0);
    EXPECT_EQ(fit_line(points).determination, 1.0);
}

}  // namespace
}  // namespace foam::texgen
