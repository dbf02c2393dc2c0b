// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/outline_file.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "core/files/input_limits.h"
#include "texgen/image/file_suffix.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/pictures/fill_coverage.h"
#include "texgen/pictures/picture_file.h"
#include "texgen/pictures/silhouette.h"
#include "texgen/pictures/svg_drawing.h"
#include "texgen/pictures/traced_outlines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kSvgSuffix = ".svg";
// A drawing (SVG) is drawn as a picture of about `grid_points` pixels (outlines_of_svg). This is
// the largest number of pixels along a side of the picture, without kMargin. Because of this limit,
// the picture of a very long drawing has fewer pixels than `grid_points`.
constexpr double kMaxSide = 16384.0;
constexpr double kMargin = 1.0;  // around the drawing, in pixels
// The largest deviation of polygons from curves, in pixels.
constexpr double kFlatness = 0.1;
// The largest total height of all sides of the polygons of a drawing, in pixels. It limits the time
// of fill_coverage to a few seconds.
constexpr double kMaxHeight = 1e7;
// Coordinates whose magnitude is not below this number are rejected, because their differences may
// be rounded to nothing.
constexpr double kMaxCoordinate = 1e12;

// The bounding box of the control points of all shapes.
struct Bounds {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;

    void add(const Vec2& point) {
        if (!(point.cwiseAbs().maxCoeff() < kMaxCoordinate)) {
            throw InputError("its coordinates are too large");
        }
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
};

Bounds bounds_of(const std::vector<SvgShape>& shapes) {
    Bounds bounds;
    for (const SvgShape& shape : shapes) {
        for (const Subpath& path : shape.path) {
            bounds.add(path.start);
            for (const CubicCurve& curve : path.curves) {
                bounds.add(curve.control_1);
                bounds.add(curve.control_2);
                bounds.add(curve.end);
            }
        }
    }
    return bounds;
}

// Returns the map from the coordinates of the document to the pixels of a picture, in which y
// points up. `size` is the size of the drawing.
AffineMap map_to_pixels(const Bounds& bounds, const Vec2& size, double grid_points) {
    const double scale =
        std::min(kMaxSide / size.maxCoeff(), std::sqrt(grid_points / (size.x() * size.y())));
    return {{scale,
             0.0,
             0.0,
             -scale,
             kMargin - scale * bounds.low.x(),
             kMargin + scale * bounds.high.y()}};
}

FilledShape filled(SvgShape shape, const AffineMap& map) {
    FilledShape result{{}, shape.is_even_odd};
    for (const Subpath& path : mapped(std::move(shape.path), map)) {
        result.rings.push_back(flattened(path, kFlatness));
    }
    return result;
}

// Returns the total height of all sides of a ring.
double total_height(const std::vector<Vec2>& ring) {
    double height = std::abs(ring.front().y() - ring.back().y());
    for (std::size_t k = 1; k < ring.size(); ++k) {
        height += std::abs(ring[k].y() - ring[k - 1].y());
    }
    return height;
}

// Returns the shapes as polygons in pixels.
std::vector<FilledShape> all_filled(std::vector<SvgShape> shapes, const AffineMap& map) {
    std::vector<FilledShape> result;
    double height = 0.0;
    for (SvgShape& shape : shapes) {
        result.push_back(filled(std::move(shape), map));
        for (const std::vector<Vec2>& ring : result.back().rings) {
            height += total_height(ring);
        }
        if (height > kMaxHeight) {
            throw InputError("it has too many long lines and curves");
        }
    }
    return result;
}

bool is_svg_name(std::string_view text) {
    return has_suffix(text, kSvgSuffix);
}

FileOutline outline_in(const std::string& path) {
    if (!is_svg_name(path)) {
        const PictureFile file = read_picture_file(path);
        return {silhouette(*file.picture), file.hash};
    }
    const Bytes content = read_file(path, kDrawingInput);
    const std::string_view document = as_text(content);
    try {
        return {outlines_of_svg(document), text_hash(document)};
    } catch (const InputError& error) {
        throw InputError(fmt::format("cannot use '{}' as an outline: {}", path, error.what()));
    }
}

}  // namespace

bool is_outline_name(std::string_view text) {
    return is_svg_name(text) || find_format(text) != nullptr;
}

std::vector<foam::Outline> outlines_of_svg(std::string_view document, double grid_points) {
    std::vector<SvgShape> shapes = read_svg_shapes(document);
    const Bounds bounds = bounds_of(shapes);
    const Vec2 size = bounds.high - bounds.low;
    if (!(size.minCoeff() > 0.0)) {
        throw InputError("it has no filled shape");
    }
    const AffineMap map = map_to_pixels(bounds, size, grid_points);
    const std::vector<FilledShape> shapes_in_pixels = all_filled(std::move(shapes), map);
    const double scale = map.abcdef[0];
    const auto pixels = [&](double length) {
        return static_cast<int>(std::ceil(scale * length + 2.0 * kMargin));
    };
    const Image<float> grid = fill_coverage(shapes_in_pixels, pixels(size.x()), pixels(size.y()));
    std::vector<foam::Outline> outlines = traced_outlines(grid, 0.5);
    if (outlines.empty()) {
        throw InputError("it has no filled shape");
    }
    return outlines;
}

FileOutline read_outline_file(const std::string& path) {
    FileOutline outline = outline_in(path);
    if (outline.parts.empty()) {
        throw InputError(
            fmt::format("cannot use '{}' as an outline: it must have an opaque part or, if nothing "
                        "is transparent, a part that is darker than half lightness",
                        path));
    }
    return outline;
}

}  // namespace foam::texgen
