#include "texgen/chart/axis_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foam::texgen {

namespace {

constexpr double kMostSteps = 7.0;     // along a linear axis, before its ends are moved out
constexpr double kLargest = 1e7;       // written without an exponent
constexpr double kSmallest = 1e-4;     // the same
constexpr double kRounding = 1e-9;     // of a step: a value so near a tick lies on it
constexpr double kDecadesAlone = 2.0;  // from so many on, only powers of ten are labelled

// The power of ten below a positive value, that value included.
int decade_of(double value) {
    return static_cast<int>(std::floor(std::log10(value) + kRounding));
}

// The smallest of 1, 2, 5 and 10 times a power of ten that is no less than the value.
double rounded_up(double value) {
    const double power = std::pow(10.0, decade_of(value));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (value <= digit * power * (1.0 + kRounding)) {
            return digit * power;
        }
    }
    return 10.0 * power;
}

AxisScale linear_scale(double low, double high) {
    if (low == high) {
        const double margin = low == 0.0 ? 1.0 : 0.5 * std::abs(low);
        return linear_scale(low - margin, high + margin);
    }
    const double step = rounded_up((high - low) / kMostSteps);
    const double first = std::floor(low / step + kRounding);
    const double last = std::ceil(high / step - kRounding);
    const int decimals = std::max(0, -decade_of(step));
    AxisScale scale{AxisKind::Linear, first * step, last * step, {}};
    for (double k = first; k <= last; k += 1.0) {
        scale.ticks.push_back({k * step, format_tick(k * step, decimals)});
    }
    return scale;
}

// 1, 2 and 5 times the powers of ten from below `low` to above `high`.
std::vector<double> logarithmic_stops(double low, double high) {
    std::vector<double> stops;
    for (int decade = decade_of(low); decade <= decade_of(high) + 1; ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            stops.push_back(digit * std::pow(10.0, decade));
        }
    }
    return stops;
}

std::vector<Tick> logarithmic_ticks(double low, double high) {
    const bool decades_alone = std::log10(high / low) >= kDecadesAlone - kRounding;
    std::vector<Tick> ticks;
    for (int decade = decade_of(low); decade <= decade_of(high); ++decade) {
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = digit * std::pow(10.0, decade);
            if (value < low * (1.0 - kRounding) || value > high * (1.0 + kRounding)) {
                continue;
            }
            const bool major = digit == 1 || (!decades_alone && (digit == 2 || digit == 5));
            ticks.push_back({value, major ? format_tick(value, std::max(0, -decade)) : ""});
        }
    }
    return ticks;
}

AxisScale logarithmic_scale(double low, double high) {
    const std::vector<double> stops = logarithmic_stops(low, high);
    AxisScale scale{AxisKind::Logarithmic, stops.front(), stops.back(), {}};
    for (const double stop : stops) {
        scale.low = stop <= low * (1.0 + kRounding) ? stop : scale.low;
    }
    const auto end = std::find_if(stops.begin(), stops.end(), [&](double stop) {
        return stop >= high * (1.0 - kRounding) && stop > scale.low;
    });
    scale.high = *end;
    scale.ticks = logarithmic_ticks(scale.low, scale.high);
    return scale;
}

// "1234567" as "1,234,567"; what follows the digits stays.
std::string with_commas(std::string number) {
    const std::size_t start = number.front() == '-' ? 1 : 0;
    std::size_t end = std::min(number.find('.'), number.size());
    while (end > start + 3) {
        end -= 3;
        number.insert(end, 1, ',');
    }
    return number;
}

}  // namespace

double AxisScale::fraction(double value) const {
    if (kind == AxisKind::Logarithmic) {
        return std::log(value / low) / std::log(high / low);
    }
    return (value - low) / (high - low);
}

AxisScale axis_scale(AxisKind kind, double low, double high) {
    return kind == AxisKind::Linear ? linear_scale(low, high) : logarithmic_scale(low, high);
}

std::string format_tick(double value, int decimals) {
    const double size = std::abs(value);
    if (size != 0.0 && (size >= kLargest || size < kSmallest)) {
        return fmt::format("{:.3g}", value);
    }
    return with_commas(fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, decimals));
}

}  // namespace foam::texgen
