#pragma once

#include "texgen/chart/chart.h"

#include <span>

namespace foam::texgen {

/// y = intercept + slope x.
struct LineFit {
    double intercept = 0.0;
    double slope = 0.0;
    double determination = 1.0;  // R squared: the share of the variance of y that the line explains

    double at(double x) const { return intercept + slope * x; }
};

/// Least squares. Precondition: two points of different x.
LineFit fit_line(std::span<const ChartPoint> points);

}  // namespace foam::texgen
