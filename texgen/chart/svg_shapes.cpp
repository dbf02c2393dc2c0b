#include "texgen/chart/svg_shapes.h"

#include <fmt/format.h>

namespace foam::texgen {

namespace {

constexpr double kRadius = 2.6;  // of a mark, pixels

std::string polyline(std::span<const ChartPoint> points, Srgb8 color, std::string_view more) {
    std::string places;
    for (const ChartPoint& point : points) {
        places += fmt::format("{}{:.2f},{:.2f}", places.empty() ? "" : " ", point.x, point.y);
    }
    return fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
        "stroke-linejoin=\"round\"{}/>\n",
        places,
        svg_color(color),
        more);
}

std::string circle(ChartPoint at) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>\n", at.x, at.y, kRadius);
}

std::string diamond(ChartPoint at) {
    constexpr double kReach = 2.2 * kRadius;
    return fmt::format(
        "<path d=\"M{:.2f} {:.2f}l{reach} {reach}l-{reach} {reach}l-{reach} -{reach}z\"/>\n",
        at.x,
        at.y - kReach,
        fmt::arg("reach", kReach));
}

std::string marks(std::span<const ChartPoint> points, Mark mark, Srgb8 color) {
    const std::string ink = svg_color(color);
    std::string group =
        mark == Mark::Discs
            ? fmt::format("<g fill=\"{}\">\n", ink)
            : fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\">\n", ink);
    for (const ChartPoint& point : points) {
        group += mark == Mark::Diamonds ? diamond(point) : circle(point);
    }
    group += "</g>\n";
    return group;
}

}  // namespace

std::string escape_xml(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
        }
    }
    return escaped;
}

std::string svg_color(Srgb8 color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

std::string svg_text(ChartPoint at,
                     std::string_view anchor,
                     std::string_view text,
                     std::string_view more) {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n",
                       at.x,
                       at.y,
                       anchor,
                       more,
                       escape_xml(text));
}

std::string svg_line(ChartPoint from, ChartPoint to) {
    return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n",
                       from.x,
                       from.y,
                       to.x,
                       to.y);
}

std::string svg_series(std::span<const ChartPoint> points, Mark mark, Srgb8 color) {
    switch (mark) {
        case Mark::Line:
            return polyline(points, color, "");
        case Mark::DashedLine:
            return polyline(points, color, " stroke-dasharray=\"6 4\"");
        default:
            return marks(points, mark, color);
    }
}

std::string svg_box(ChartPoint corner, ChartPoint opposite, Srgb8 color) {
    return fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
        corner.x,
        corner.y,
        opposite.x - corner.x,
        opposite.y - corner.y,
        svg_color(color));
}

}  // namespace foam::texgen
