#include "texgen/chart/svg_chart.h"

#include "texgen/chart/axis_scale.h"
#include "texgen/chart/svg_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace foam::texgen {

namespace {

// Pixels; y points down.
constexpr double kLeft = 80.0;  // of the plot, and so on: room for the labels around it
constexpr double kTop = 40.0;
constexpr double kRight = 560.0;
constexpr double kBottom = 340.0;
constexpr double kHeight = 396.0;
constexpr double kMargin = 20.0;
constexpr double kTitleRise = 16.0;
constexpr double kMajorTick = 6.0;
constexpr double kMinorTick = 3.0;
constexpr double kLegendLine = 21.0;
constexpr double kLegendSample = 26.0;
constexpr double kLegendGap = 8.0;       // between a sample and its name
constexpr double kCharacter = 6.4;       // mean width of a character of a legend
constexpr double kBaseline = 4.0;        // of a text below the middle of its letters
constexpr double kTickLabelDrop = 18.0;  // of the baseline below the plot
constexpr double kAxisLabelDrop = 42.0;
constexpr double kAxisLabelReach = 58.0;  // of the vertical label to the left of the plot

bool is_shown(const Axis& axis, double value) {
    return std::isfinite(value) && (axis.kind == AxisKind::Linear || value > 0.0);
}

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take_in(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

AxisScale scale_of(const Axis& axis, const Extent& extent) {
    if (extent.low <= extent.high) {
        return axis_scale(axis.kind, extent.low, extent.high);
    }
    return axis.kind == AxisKind::Linear ? axis_scale(axis.kind, 0.0, 1.0)
                                         : axis_scale(axis.kind, 1.0, 10.0);
}

// Where the values of a chart come to lie.
struct Layout {
    AxisScale x;
    AxisScale y;

    double at_x(double value) const { return kLeft + (kRight - kLeft) * x.fraction(value); }
    double at_y(double value) const { return kBottom - (kBottom - kTop) * y.fraction(value); }
};

std::vector<ChartPoint> shown_points(const Chart& chart, const Series& series) {
    std::vector<ChartPoint> shown;
    for (const ChartPoint& point : series.points) {
        if (is_shown(chart.x, point.x) && is_shown(chart.y, point.y)) {
            shown.push_back(point);
        }
    }
    return shown;
}

Layout layout_of(const Chart& chart) {
    Extent x;
    Extent y;
    for (const Series& series : chart.series) {
        for (const ChartPoint& point : shown_points(chart, series)) {
            x.take_in(point.x);
            y.take_in(point.y);
        }
    }
    for (const Band& band : chart.bands) {
        y.take_in(band.low);
        y.take_in(band.high);
    }
    return {scale_of(chart.x, x), scale_of(chart.y, y)};
}

std::string bands(const Chart& chart, const Layout& layout) {
    std::string out;
    for (const Band& band : chart.bands) {
        out +=
            svg_box({kLeft, layout.at_y(band.high)}, {kRight, layout.at_y(band.low)}, band.color);
    }
    return out;
}

std::string series(const Chart& chart, const Layout& layout) {
    std::string out;
    for (const Series& one : chart.series) {
        std::vector<ChartPoint> places = shown_points(chart, one);
        for (ChartPoint& place : places) {
            place = {layout.at_x(place.x), layout.at_y(place.y)};
        }
        out += svg_series(places, one.mark, one.color);
    }
    return out;
}

// Lines across the plot at the labelled ticks.
std::string grid(const Layout& layout) {
    std::string out = "<g stroke=\"#e6e6e6\">\n";
    for (const Tick& tick : layout.x.ticks) {
        const double x = layout.at_x(tick.value);
        out += tick.label.empty() ? "" : svg_line({x, kTop}, {x, kBottom});
    }
    for (const Tick& tick : layout.y.ticks) {
        const double y = layout.at_y(tick.value);
        out += tick.label.empty() ? "" : svg_line({kLeft, y}, {kRight, y});
    }
    out += "</g>\n";
    return out;
}

double tick_length(const Tick& tick) {
    return tick.label.empty() ? kMinorTick : kMajorTick;
}

// The plot's outline, with ticks that point into it.
std::string outline(const Layout& layout) {
    std::string out = "<g stroke=\"#222222\">\n";
    for (const Tick& tick : layout.x.ticks) {
        const double x = layout.at_x(tick.value);
        out += svg_line({x, kBottom}, {x, kBottom - tick_length(tick)});
    }
    for (const Tick& tick : layout.y.ticks) {
        const double y = layout.at_y(tick.value);
        out += svg_line({kLeft, y}, {kLeft + tick_length(tick), y});
    }
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\"/>\n</g>\n",
                       kLeft,
                       kTop,
                       kRight - kLeft,
                       kBottom - kTop);
    return out;
}

std::string tick_labels(const Layout& layout) {
    std::string out;
    for (const Tick& tick : layout.x.ticks) {
        const ChartPoint at{layout.at_x(tick.value), kBottom + kTickLabelDrop};
        out += tick.label.empty() ? "" : svg_text(at, "middle", tick.label);
    }
    for (const Tick& tick : layout.y.ticks) {
        const ChartPoint at{kLeft - kLegendGap, layout.at_y(tick.value) + kBaseline};
        out += tick.label.empty() ? "" : svg_text(at, "end", tick.label);
    }
    return out;
}

std::string titles(const Chart& chart) {
    constexpr double kMiddle = 0.5 * (kTop + kBottom);
    const std::string turned =
        fmt::format(" transform=\"rotate(-90 {} {})\"", kLeft - kAxisLabelReach, kMiddle);
    const std::string bold = " font-size=\"14\" font-weight=\"bold\"";
    std::string out = svg_text({kLeft, kTop - kTitleRise}, "start", chart.title, bold);
    out += svg_text({0.5 * (kLeft + kRight), kBottom + kAxisLabelDrop}, "middle", chart.x.label);
    out += svg_text({kLeft - kAxisLabelReach, kMiddle}, "middle", chart.y.label, turned);
    return out;
}

// What stands for a series in the legend, its middle at a height.
std::string sample(const Series& series, double y) {
    constexpr double kStart = kRight + kMargin;
    const bool is_line = series.mark == Mark::Line || series.mark == Mark::DashedLine;
    const std::vector<ChartPoint> places =
        is_line ? std::vector<ChartPoint>{{kStart, y}, {kStart + kLegendSample, y}}
                : std::vector<ChartPoint>{{kStart + 0.5 * kLegendSample, y}};
    return svg_series(places, series.mark, series.color);
}

std::string legend_name(const std::string& name, double y) {
    return svg_text({kRight + kMargin + kLegendSample + kLegendGap, y + kBaseline}, "start", name);
}

std::string legend(const Chart& chart) {
    constexpr double kStart = kRight + kMargin;
    std::string out;
    double y = kTop + 0.5 * kLegendLine;
    for (const Series& one : chart.series) {
        if (!one.name.empty()) {
            out += sample(one, y);
            out += legend_name(one.name, y);
            y += kLegendLine;
        }
    }
    for (const Band& band : chart.bands) {
        out += svg_box({kStart, y - 6.0}, {kStart + kLegendSample, y + 6.0}, band.color);
        out += legend_name(band.name, y);
        y += kLegendLine;
    }
    return out;
}

// Bytes that do not begin a character of UTF-8 have no width.
std::size_t count_characters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

double width_of(const Chart& chart) {
    std::size_t longest = 0;
    for (const Series& one : chart.series) {
        longest = std::max(longest, count_characters(one.name));
    }
    for (const Band& band : chart.bands) {
        longest = std::max(longest, count_characters(band.name));
    }
    const double names = std::ceil(kCharacter * static_cast<double>(longest));
    return longest == 0 ? kRight + kMargin
                        : kRight + 2.0 * kMargin + kLegendSample + kLegendGap + names;
}

std::string head(const Chart& chart) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\" "
        "font-size=\"12\" fill=\"#222222\">\n"
        "<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        width_of(chart),
        kHeight,
        escape_xml(chart.title));
}

}  // namespace

std::string to_svg(const Chart& chart) {
    const Layout layout = layout_of(chart);
    std::string out = head(chart);
    for (const std::string& part : {bands(chart, layout),
                                    grid(layout),
                                    series(chart, layout),
                                    outline(layout),
                                    tick_labels(layout),
                                    titles(chart),
                                    legend(chart)}) {
        out += part;
    }
    out += "</svg>\n";
    return out;
}

}  // namespace foam::texgen
