// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/svg.h"

#include "core/files/shown_text.h"
#include "core/geometry/elementary.h"
#include "texgen/vector/number_text.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// The command A gives an arc by its ends and its radius. If an arc turns by almost 180 degrees,
// rounding the radius noticeably changes the area between the arc and its chord. Arcs with a half
// angle above this limit are therefore written as two arcs (four, if the half angle is above 170
// degrees). The limit, 85 degrees, is above the largest half angle of an inner film, 80 degrees (E3
// in core/EQUATIONS.md).
constexpr double kMaxHalfAngle = 85.0 / 180.0 * std::numbers::pi;
// Arcs with a smaller half angle are written as lines. The area between such an arc and its chord
// is less than 1e-10 times the square of the chord.
constexpr double kMinHalfAngle = 1e-10;
constexpr double kJunctionRadius = 0.2;  // millimeters

// Escapes a text for XML. Control characters become spaces, because XML forbids most of them.
// Invalid UTF-8 is replaced, because XML forbids it.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : valid_utf8(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
        }
    }
    return result;
}

// Writes paths. In SVG, y points down from the upper left corner.
class PathWriter {
  public:
    explicit PathWriter(double height) : height_(height) {}

    std::string path_of(const std::vector<Chain>& chains) {
        text_.clear();
        for (const Chain& chain : chains) {
            text_ += 'M';
            text_ += point(chain.tail);
            for (const DrawnArc& arc : arcs_of(chain)) {
                add(arc);
            }
            text_ += chain.is_closed ? "Z" : "";
        }
        return text_;
    }

    std::string point(const Vec2& position) const {
        return length_text(position.x()) + "," + length_text(height_ - position.y());
    }

  private:
    void add(const DrawnArc& arc) {
        const double half_angle = std::abs(arc.half_angle);
        if (half_angle > kMaxHalfAngle) {
            const Vec2 middle = arc.tail + point_at(arc.arc(), 0.5);
            add({arc.tail, middle, 0.5 * arc.half_angle});
            add({middle, arc.head, 0.5 * arc.half_angle});
        } else if (half_angle < kMinHalfAngle) {
            text_ += "L" + point(arc.head);
        } else {
            const double radius = 0.5 * (arc.head - arc.tail).norm() / ieee::sin(half_angle);
            const std::string r = length_text(radius);
            text_ += "A" + r + "," + r + " 0 0," + (arc.half_angle > 0.0 ? "0 " : "1 ") +
                     point(arc.head);
        }
    }

    double height_;
    std::string text_;
};

std::string color_or_none(const std::string& color) {
    return color.empty() ? "none" : color;
}

std::string style_of(const Style& style) {
    std::string text = fmt::format(" fill=\"{}\"", color_or_none(style.fill));
    if (!style.stroke.empty()) {
        text += fmt::format(
            " stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
            "stroke-linejoin=\"round\"",
            style.stroke,
            length_text(style.stroke_width));
    }
    return text;
}

std::string layer_start(const std::string& name) {
    return fmt::format("<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\"", name);
}

std::string text_of(const Shape& shape, PathWriter& paths) {
    std::string text = "<path";
    if (!shape.id.empty()) {
        text += fmt::format(" id=\"{}\"", shape.id);
    }
    text += fmt::format(" class=\"{}\"", shape.kind);
    if (!shape.fill.empty()) {
        text += fmt::format(" fill=\"{}\"", shape.fill);
    }
    for (const auto& [name, value] : shape.data) {
        text += fmt::format(" data-{}=\"{}\"", name, value);
    }
    return text + " d=\"" + paths.path_of(shape.chains) + "\"/>\n";
}

std::string text_of(const Layer& layer, PathWriter& paths) {
    std::string text = layer_start(layer.name) + style_of(layer.style) + ">\n";
    for (const Shape& shape : layer.shapes) {
        text += text_of(shape, paths);
    }
    return text + "</g>\n";
}

// The layer of the junctions is hidden, because the maps do not show junctions.
std::string junctions_of(const Drawing& drawing, const PathWriter& paths) {
    std::string text = layer_start("junctions") + " style=\"display:none\">\n";
    for (const Vec2& junction : drawing.junctions) {
        const std::string center = paths.point(junction);
        const std::size_t comma = center.find(',');
        text += fmt::format("<circle class=\"junction\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                            center.substr(0, comma),
                            center.substr(comma + 1),
                            length_text(kJunctionRadius));
    }
    return text + "</g>\n";
}

}  // namespace

std::string to_svg(const Drawing& drawing) {
    const Box box = drawing.page_box();
    const std::string width = length_text(box.high.x() - box.low.x());
    const std::string height = length_text(box.high.y() - box.low.y());
    PathWriter paths(drawing.height);
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
        "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{3} {4} {0} {1}\" "
        "data-mm-per-foam-unit=\"{2}\">\n",
        width,
        height,
        exact_text(drawing.scale),
        length_text(box.low.x()),
        length_text(drawing.height - box.high.y()));
    text += "<title>" + escaped(drawing.title) + "</title>\n";
    if (!drawing.description.empty()) {
        text += "<desc>" + escaped(drawing.description) + "</desc>\n";
    }
    if (!drawing.background.empty()) {
        text += fmt::format("<rect id=\"background\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                            width,
                            height,
                            drawing.background);
    }
    for (const Layer& layer : drawing.layers) {
        text += text_of(layer, paths);
    }
    return text + junctions_of(drawing, paths) + "</svg>\n";
}

}  // namespace foam::texgen
