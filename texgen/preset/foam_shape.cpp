// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/foam_shape.h"

#include "core/files/file_io.h"
#include "texgen/image/format.h"
#include "texgen/image/memory.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/pictures/picture_file.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::array<std::string_view, 2> kNamedOutlines{"disc", "rectangle"};

// Returns the outline of a shape before it is stretched.
std::vector<foam::Outline> unstretched_outline(const FoamShape& shape) {
    if (shape.file_outline) {
        return shape.file_outline->parts;
    }
    if (shape.outline == "disc") {
        return {disc_outline()};
    }
    if (shape.outline == "rectangle") {
        return {rectangle_outline(1.0)};
    }
    return {outline_from_wkt(shape.outline)};
}

// Sets the outline of a shape to a value of the key foam.outline. Throws std::invalid_argument or
// InputError if the text describes no outline, and OutOfMemory if the file that it names needs more
// memory than is available.
void set_outline(const std::string& text, FoamShape& shape) {
    FoamShape changed{.kind = shape.kind, .outline = text, .outline_aspect = 1.0};
    if (is_outline_name(text)) {
        changed.file_outline = std::make_shared<const FileOutline>(read_outline_file(text));
    }
    outline_of(changed);  // throws if the text is not allowed or the outline has no area
    changed.outline_aspect = shape.outline_aspect;
    shape = std::move(changed);
}

// Sets the outline of a shape as set_outline does, and returns an empty string. If set_outline
// throws, returns the message of its exception instead and does not change the shape.
std::string try_set_outline(const std::string& text, FoamShape& shape) {
    try {
        set_outline(text, shape);
        return {};
    } catch (const std::invalid_argument& error) {
        return error.what();
    } catch (const InputError& error) {
        return error.what();
    } catch (const OutOfMemory& error) {
        return error.what();
    }
}

// The kind of values of foam.outline: "disc", "rectangle", a polygon as WKT, or a file. `read` and
// `write` take the whole shape instead of one member, because a value sets two members: `outline`
// and `file_outline`.
struct Outlines {
    std::string allowed() const {
        return fmt::format(
            "\"disc\", \"rectangle\", a WKT polygon without self-intersections, such as "
            "\"POLYGON((0 0, 6 0, 6 4), (3 1, 5 1, 5 2))\", or the path of a drawing or a picture, "
            "which ends in .svg, {}",
            format_suffixes());
    }
    std::string schema() const {
        return fmt::format(
            R"({{"type": "string", "pattern": "^(disc|rectangle| *[Pp][Oo][Ll][Yy][Gg][Oo][Nn].*|.*\\.[sS][vV][gG]|.*{})$"}})",
            picture_suffix_pattern());
    }
    std::span<const std::string_view> words() const { return kNamedOutlines; }
    bool read(const Value& value, FoamShape& shape) const {
        const auto* text = std::get_if<std::string>(&value.data);
        return text != nullptr && try_set_outline(*text, shape).empty();
    }
    Value write(const FoamShape& shape) const { return {shape.outline}; }
    std::optional<NamedFile> file(const FoamShape& shape) const {
        return shape.file_outline
                   ? std::optional(NamedFile{shape.outline, shape.file_outline->hash})
                   : std::nullopt;
    }
    std::string fault(const Value& value) const {
        FoamShape ignored;
        const auto* text = std::get_if<std::string>(&value.data);
        return text != nullptr ? try_set_outline(*text, ignored) : std::string();
    }
};

void stretch(std::vector<Vec2>& corners, double factor) {
    for (Vec2& corner : corners) {
        corner.x() *= factor;
    }
}

}  // namespace

Keys<FoamShape> shape_keys() {
    constexpr Choices<FoamKind> kKinds = {
        {{{"torus", FoamKind::Torus}, {"patch", FoamKind::Patch}}}};
    return {key("domain",
                kKinds,
                "a torus, which tiles, or a patch with a free surface on a transparent background",
                &FoamShape::kind),
            make_key<FoamShape>(
                "outline",
                Outlines{},
                "initial outline of a patch, scaled to an area of one per bubble: a disc, a "
                "rectangle, a polygon, the filled shapes of an SVG, or the opaque or dark part of "
                "a picture; in equilibrium the patch has another outline",
                [](auto& shape) -> auto& { return shape; })
                .with_files(is_outline_name)
                .only_for("foam.domain", {"patch"}),
            key("outline_aspect",
                Reals{1.0 / 16.0, 16.0},
                "factor that stretches the outline in x; for a disc or a rectangle, width / height",
                &FoamShape::outline_aspect)
                .only_for("foam.domain", {"patch"})};
}

std::vector<foam::Outline> outline_of(const FoamShape& shape) {
    std::vector<foam::Outline> parts = unstretched_outline(shape);
    for (foam::Outline& part : parts) {
        stretch(part.outer, shape.outline_aspect);
        for (std::vector<Vec2>& hole : part.holes) {
            stretch(hole, shape.outline_aspect);
        }
        const double area = outline_area(part);
        if (!(area > 0.0) || !std::isfinite(area)) {
            throw std::invalid_argument(
                "the outline has no area: it needs at least three corners "
                "that are not on one line");
        }
    }
    return parts;
}

}  // namespace foam::texgen
