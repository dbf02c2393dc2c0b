#pragma once

#include "texgen/chart/chart.h"

#include <string>
#include <vector>

namespace foam::texgen {

struct Tick {
    double value = 0.0;
    std::string label;  // empty for a minor tick
};

/// Where values lie along an axis, and its ticks.
struct AxisScale {
    AxisKind kind = AxisKind::Linear;
    double low = 0.0;  // the ends of the axis; low < high, and 0 < low on a logarithm
    double high = 1.0;
    std::vector<Tick> ticks;  // in increasing order

    /// 0 at the low end, 1 at the high one.
    double fraction(double value) const;
};

/// An axis that takes in two values, its ends moved out to ticks: three to nine steps of 1, 2 or 5
/// times a power of ten; on a logarithm to 1, 2 or 5 times a power of ten, of which only the powers
/// of ten bear labels where the axis is two or more long. Where the values are equal the axis gets
/// some length all the same. Preconditions: low <= high, both finite, and 0 < low on a logarithm.
AxisScale axis_scale(AxisKind kind, double low, double high);

/// A number as people write it: 12,000 and 0.05; beyond 1e7 and below 1e-4 with an exponent.
/// `decimals` digits come after the point.
std::string format_tick(double value, int decimals);

}  // namespace foam::texgen
