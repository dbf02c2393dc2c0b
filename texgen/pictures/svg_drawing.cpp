// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_drawing.h"

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/pictures/svg_element.h"
#include "texgen/pictures/svg_path.h"
#include "texgen/pictures/svg_text.h"
#include "texgen/pictures/svg_viewport.h"

#include <fmt/core.h>
#include <pugixml.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace foam::texgen {

namespace {

using Node = pugi::xml_node;

constexpr int kMaxDepth = 64;
// These limits bound the time that a document with nested <use> elements can take.
constexpr std::size_t kMaxCurves = 100'000;
constexpr int kMaxElements = 200'000;

// The properties that an element inherits from the elements around it.
struct Style {
    AffineMap map;
    // The size of the viewport around the element; percentages refer to this size.
    Vec2 viewport{0.0, 0.0};
    bool is_filled = true;
    bool is_visible = true;
    bool is_even_odd = false;

    // Returns the style of `node`, given that the element around it has this style.
    Style style_of(const Node& node) const {
        Style style = *this;
        style.map = map * parse_svg_transform(node.attribute("transform").value());
        if (const std::string_view fill = element_property(node, "fill"); !fill.empty()) {
            style.is_filled = fill != "none" && fill != "transparent";
        }
        if (const std::string_view rule = element_property(node, "fill-rule"); !rule.empty()) {
            style.is_even_odd = rule == "evenodd";
        }
        if (const std::string_view visible = element_property(node, "visibility");
            !visible.empty()) {
            style.is_visible = visible == "visible";
        }
        return style;
    }
};

bool is_displayed(const Node& node) {
    const double opacity = SvgText(element_property(node, "opacity")).number().value_or(1.0);
    return opacity > 0.0 && element_property(node, "display") != "none";
}

double length(const Node& node, const char* name) {
    return element_length(node, name).value_or(0.0);
}

// Returns the size of the viewport of a document in the coordinates of its content. This is the
// size of the viewBox if there is one.
Vec2 viewport_of_document(const Node& root) {
    if (const auto box = parse_svg_view_box(root.attribute("viewBox").value())) {
        return box->size;
    }
    const Vec2 size(300.0, 150.0);  // the default of CSS
    return {parse_svg_length(root.attribute("width").value(), size.x()).value_or(size.x()),
            parse_svg_length(root.attribute("height").value(), size.y()).value_or(size.y())};
}

// Returns the style that the children of an <svg> or a <symbol> inherit, or nullopt if its viewport
// is empty. `style` is the style of the element itself. If a <use> of the element states a size,
// this size replaces the size of the element. `use` is null if there is no <use>.
std::optional<Style> style_in_viewport(const Style& style, const Node& node, const Node& use) {
    const auto position = [&](const char* name, double whole) {
        return element_length(node, name, whole).value_or(0.0);
    };
    const auto extent = [&](const char* name, double whole) {
        const std::optional<double> given = element_length(use, name, whole);
        return given ? *given : element_length(node, name, whole).value_or(whole);
    };
    const Vec2& outer = style.viewport;
    const Vec2 low(position("x", outer.x()), position("y", outer.y()));
    const Vec2 size(extent("width", outer.x()), extent("height", outer.y()));
    const SvgViewBox box = parse_svg_view_box(node.attribute("viewBox").value())
                               .value_or(SvgViewBox{{0.0, 0.0}, size});
    if (!(size.minCoeff() > 0.0 && box.size.minCoeff() > 0.0)) {
        return std::nullopt;
    }
    Style inner = style;
    inner.map = style.map * AffineMap::translation(low.x(), low.y()) *
                view_box_map(box, node.attribute("preserveAspectRatio").value(), size);
    inner.viewport = box.size;
    return inner;
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
    const std::optional<double> rx = element_length(node, "rx");
    const std::optional<double> ry = element_length(node, "ry");
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

// Returns the path of an element that can be filled: a <path> or a basic shape other than <line>.
// Returns nullopt for any other element.
std::optional<BezierPath> path_of(const Node& node) {
    const std::string_view name = element_name(node);
    const auto center = [&] { return Vec2(length(node, "cx"), length(node, "cy")); };
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
        return ellipse(center(), Vec2::Constant(length(node, "r")));
    }
    if (name == "ellipse") {
        return ellipse(center(), {length(node, "rx"), length(node, "ry")});
    }
    return std::nullopt;
}

// Collects the shapes of the elements of a document.
class ShapeReader {
  public:
    explicit ShapeReader(const Node& root) {
        collect_ids(root);
        Style style = Style{}.style_of(root);
        style.viewport = viewport_of_document(root);
        read_children(root, style, 0);
    }

    std::vector<SvgShape> shapes;

  private:
    // Collects the elements that have an id, so that a <use> can refer to them. If several elements
    // have the same id, the first one counts.
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

    // Reads an element. `use` is the <use> that refers to it, or null.
    void read(const Node& node, const Node& use, const Style& outer, int depth) {
        if (node.type() != pugi::node_element || !is_displayed(node)) {
            return;
        }
        if (depth > kMaxDepth || ++elements_ > kMaxElements) {
            throw InputError("its elements are nested too deeply, or are too many");
        }
        const Style style = outer.style_of(node);
        const std::string_view name = element_name(node);
        if (name == "g" || name == "a" || name == "switch") {
            read_children(node, style, depth);
        } else if (name == "svg") {
            read_viewport(node, use, style, depth);
        } else if (name == "use") {
            read_use(node, style, depth);
        } else if (name == "text" && style.is_visible) {
            throw InputError(
                "text has no outline; convert it to paths (in Inkscape: Path > Object "
                "to Path), or remove it");
        } else if (style.is_filled && style.is_visible) {
            add_if_shape(node, style);
        }
    }

    void read_children(const Node& node, const Style& style, int depth) {
        for (const Node& child : node.children()) {
            read(child, Node(), style, depth + 1);
        }
    }

    void read_viewport(const Node& node, const Node& use, const Style& style, int depth) {
        if (const std::optional<Style> inner = style_in_viewport(style, node, use)) {
            read_children(node, *inner, depth);
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
        moved.map = style.map * AffineMap::translation(length(node, "x"), length(node, "y"));
        if (element_name(found->second) == "symbol") {
            read_viewport(found->second, node, moved.style_of(found->second), depth + 1);
        } else {
            read(found->second, node, moved, depth + 1);
        }
    }

    void add_if_shape(const Node& node, const Style& style) {
        const std::optional<BezierPath> path = path_of(node);
        if (!path) {
            return;
        }
        for (const Subpath& part : *path) {
            curves_ += part.curves.size() + 1;  // the start of a subpath counts, too
        }
        if (curves_ > kMaxCurves) {
            throw InputError(
                fmt::format("it has more than {} lines, curves and subpaths", kMaxCurves));
        }
        shapes.push_back({mapped(*path, style.map), style.is_even_odd});
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
    if (element_name(root) != "svg") {
        throw InputError("it is XML, but no SVG");
    }
    return ShapeReader(root).shapes;
}

}  // namespace foam::texgen
