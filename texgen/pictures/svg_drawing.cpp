// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_drawing.h"

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/pictures/svg_path.h"
#include "texgen/pictures/svg_text.h"

#include <fmt/core.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace foam::texgen {

namespace {

using Node = pugi::xml_node;

constexpr int kMaxDepth = 64;
// These limits bound the time that a document with nested <use> elements can take.
constexpr std::size_t kMaxCurves = 100'000;
constexpr int kMaxElements = 200'000;

// Returns the name of an element without the prefix of its namespace.
std::string_view name_of(const Node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
}

// Returns a property from the attribute `style` ("fill:none; opacity:0") or else from the attribute
// with its name; empty if there is neither.
std::string_view property(const Node& node, std::string_view name) {
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
        const std::string_view one = style.substr(0, style.find(';'));
        style.remove_prefix(std::min(style.size(), one.size() + 1));
        const std::size_t colon = one.find(':');
        const auto trimmed = [](std::string_view text) {
            const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
            return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
        };
        if (colon != std::string_view::npos && trimmed(one.substr(0, colon)) == name) {
            return trimmed(one.substr(colon + 1));
        }
    }
    return node.attribute(std::string(name).c_str()).value();
}

// The properties that an element inherits from the elements around it.
struct Style {
    AffineMap map;
    bool is_filled = true;
    bool is_visible = true;
    bool is_even_odd = false;

    // Returns the style of an element within an element of this style.
    Style within(const Node& node) const {
        Style style = *this;
        style.map = map * parse_svg_transform(node.attribute("transform").value());
        if (const std::string_view fill = property(node, "fill"); !fill.empty()) {
            style.is_filled = fill != "none" && fill != "transparent";
        }
        if (const std::string_view rule = property(node, "fill-rule"); !rule.empty()) {
            style.is_even_odd = rule == "evenodd";
        }
        if (const std::string_view visible = property(node, "visibility"); !visible.empty()) {
            style.is_visible = visible == "visible";
        }
        return style;
    }
};

bool is_displayed(const Node& node) {
    return property(node, "display") != "none" && property(node, "opacity") != "0";
}

// Returns the number of pixels per unit of length, or nullopt for other units.
std::optional<double> pixels_per(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"", 1.0},
                                                                            {"px", 1.0},
                                                                            {"mm", 96.0 / 25.4},
                                                                            {"cm", 96.0 / 2.54},
                                                                            {"in", 96.0},
                                                                            {"pt", 96.0 / 72.0},
                                                                            {"pc", 16.0}}};
    const auto* const found = std::ranges::find(kUnits, unit, &decltype(kUnits)::value_type::first);
    return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

// Returns a length in pixels, or nullopt if the attribute is missing or is "auto". Throws
// InputError for other texts.
std::optional<double> length_or_none(const Node& node, const char* name) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (attribute.empty() || std::string_view(attribute.value()) == "auto") {
        return std::nullopt;
    }
    SvgText text(attribute.value());
    const std::optional<double> number = text.number();
    const std::optional<double> unit = pixels_per(text.word());
    if (!number || !unit || !text.is_at_end()) {
        throw InputError(fmt::format("{}=\"{}\" of a <{}> is no length in px, mm, cm, in, pt or pc",
                                     name,
                                     cut_text(attribute.value()),
                                     name_of(node)));
    }
    return *number * *unit;
}

double length(const Node& node, const char* name) {
    return length_or_none(node, name).value_or(0.0);
}

BezierPath ellipse(const Vec2& center, const Vec2& radii) {
    const Vec2 right = center + Vec2(radii.x(), 0.0);
    const Vec2 left = center - Vec2(radii.x(), 0.0);
    Subpath path{right};
    add_arc(path, {radii, 0.0, false, true, left});
    add_arc(path, {radii, 0.0, false, true, right});
    return {path};
}

// Returns a rectangle whose corners may be round. If only one radius is given, it is used in both
// directions. Radii are limited to half of the size.
BezierPath rectangle(const Node& node) {
    const Vec2 low(length(node, "x"), length(node, "y"));
    const Vec2 size(length(node, "width"), length(node, "height"));
    if (!(size.minCoeff() > 0.0)) {
        return {};
    }
    const std::optional<double> rx = length_or_none(node, "rx");
    const std::optional<double> ry = length_or_none(node, "ry");
    const Vec2 given(rx ? *rx : ry.value_or(0.0), ry ? *ry : rx.value_or(0.0));
    const Vec2 r = given.cwiseMax(0.0).cwiseMin(0.5 * size);
    const Vec2 high = low + size;
    const auto corner = [&](double x, double y) {
        return EllipticalArc{r, 0.0, false, true, {x, y}};
    };
    Subpath path{{low.x() + r.x(), low.y()}};
    path.add_line({high.x() - r.x(), low.y()});
    add_arc(path, corner(high.x(), low.y() + r.y()));
    path.add_line({high.x(), high.y() - r.y()});
    add_arc(path, corner(high.x() - r.x(), high.y()));
    path.add_line({low.x() + r.x(), high.y()});
    add_arc(path, corner(low.x(), high.y() - r.y()));
    path.add_line({low.x(), low.y() + r.y()});
    add_arc(path, corner(low.x() + r.x(), low.y()));
    return {path};
}

// Returns the path of a basic shape, or nullopt if the element is no basic shape.
std::optional<BezierPath> path_of(const Node& node) {
    const std::string_view name = name_of(node);
    const Vec2 center(length(node, "cx"), length(node, "cy"));
    if (name == "path") {
        return parse_svg_path(node.attribute("d").value());
    }
    if (name == "polygon" || name == "polyline") {
        return parse_svg_points(node.attribute("points").value());
    }
    if (name == "rect") {
        return rectangle(node);
    }
    if (name == "circle") {
        return ellipse(center, Vec2::Constant(length(node, "r")));
    }
    if (name == "ellipse") {
        return ellipse(center, {length(node, "rx"), length(node, "ry")});
    }
    return std::nullopt;
}

// Collects the shapes of the elements of a document.
class ShapeReader {
  public:
    explicit ShapeReader(const Node& root) {
        collect_ids(root);
        read_children(root, Style{}.within(root), 0);
    }

    std::vector<SvgShape> shapes;

  private:
    // Collects the elements that can be used by their ids. Of several elements with the same id,
    // the first one counts.
    void collect_ids(const Node& root) {
        struct Walker : pugi::xml_tree_walker {
            explicit Walker(std::map<std::string, Node>& map) : by_id(map) {}
            bool for_each(Node& node) override {
                if (const pugi::xml_attribute id = node.attribute("id")) {
                    by_id.emplace(id.value(), node);
                }
                return true;
            }
            std::map<std::string, Node>& by_id;
        };
        Walker walker(by_id_);
        Node(root).traverse(walker);
    }

    void read(const Node& node, const Style& outer, int depth) {
        if (node.type() != pugi::node_element || !is_displayed(node)) {
            return;
        }
        if (depth > kMaxDepth || ++elements_ > kMaxElements) {
            throw InputError("its elements are nested too deeply, or are too many");
        }
        const Style style = outer.within(node);
        const std::string_view name = name_of(node);
        if (name == "g" || name == "svg" || name == "a" || name == "switch") {
            read_children(node, style, depth);
        } else if (name == "use") {
            read_use(node, style, depth);
        } else if (name == "text" && style.is_visible) {
            throw InputError(
                "text has no outline; convert it to paths (in Inkscape: Path > Object "
                "to Path), or remove it");
        } else if (const std::optional<BezierPath> path = path_of(node)) {
            add(*path, style);
        }
    }

    void read_children(const Node& node, const Style& style, int depth) {
        for (const Node& child : node.children()) {
            read(child, style, depth + 1);
        }
    }

    void read_use(const Node& node, const Style& style, int depth) {
        const pugi::xml_attribute plain = node.attribute("href");
        const std::string_view href = (plain ? plain : node.attribute("xlink:href")).value();
        const auto found = by_id_.find(std::string(href.substr(href.starts_with('#') ? 1 : 0)));
        if (found == by_id_.end()) {
            throw InputError(
                fmt::format("<use> refers to '{}', which does not exist", cut_text(href)));
        }
        Style moved = style;
        moved.map =
            style.map * AffineMap{{1.0, 0.0, 0.0, 1.0, length(node, "x"), length(node, "y")}};
        if (name_of(found->second) == "symbol") {
            read_children(found->second, moved.within(found->second), depth + 1);
        } else {
            read(found->second, moved, depth + 1);
        }
    }

    void add(const BezierPath& path, const Style& style) {
        if (!style.is_filled || !style.is_visible) {
            return;
        }
        for (const Subpath& part : path) {
            curves_ += part.curves.size();
        }
        if (curves_ > kMaxCurves) {
            throw InputError(fmt::format("it has more than {} lines and curves", kMaxCurves));
        }
        shapes.push_back({mapped(path, style.map), style.is_even_odd});
    }

    std::map<std::string, Node> by_id_;
    std::size_t curves_ = 0;
    int elements_ = 0;
};

}  // namespace

std::vector<SvgShape> read_svg_shapes(std::string_view document) {
    pugi::xml_document xml;
    const pugi::xml_parse_result result = xml.load_buffer(document.data(), document.size());
    if (!result) {
        throw InputError(
            fmt::format("it is not valid XML: {} at byte {}", result.description(), result.offset));
    }
    const Node root = xml.document_element();
    if (name_of(root) != "svg") {
        throw InputError("it is XML, but no SVG");
    }
    return ShapeReader(root).shapes;
}

}  // namespace foam::texgen
