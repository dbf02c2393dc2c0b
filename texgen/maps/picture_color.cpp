// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/picture_color.h"

#include "core/foam/polygon_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

// A bubble is sampled as a polygon: each arc is replaced by kChordsPerArc chords.

namespace foam::texgen {

namespace {

constexpr int kChordsPerArc = 4;
constexpr int kCircleCorners = 24;  // number of corners of the polygon of a lone bubble
// The smallest spacing of samples, as a fraction of the longer side of the rectangle over which the
// picture is stretched (PlacedPicture).
constexpr double kFinestSpacing = 1.0 / 512.0;

using Polygon = std::vector<Vec2>;

// Returns the polygon of a bubble of the network. On a torus, its corners are not wrapped into the
// fundamental cell, so that the polygon is connected.
Polygon polygon_of(const Frame& frame, BubbleId bubble) {
    Polygon polygon;
    const HalfEdgeId first = frame.network.first(bubble);
    Vec2 corner = frame.positions[frame.network.tail(first)];
    HalfEdgeId h = first;
    do {
        const FilmArc arc = frame.arc(h);
        for (int k = 0; k < kChordsPerArc; ++k) {
            polygon.push_back(corner + point_at(arc, static_cast<double>(k) / kChordsPerArc));
        }
        corner += arc.chord;
        h = frame.network.next(h);
    } while (h != first);
    return polygon;
}

Polygon polygon_of(const LoneBubble& bubble) {
    Polygon polygon;
    const double radius = std::sqrt(bubble.target_area / std::numbers::pi);
    for (int k = 0; k < kCircleCorners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kCircleCorners;
        polygon.push_back(bubble.center + radius * unit_vector(angle));
    }
    return polygon;
}

PerBubble<Polygon> polygons_of(const Frame& frame) {
    return per_bubble<Polygon>(
        frame,
        [&](BubbleId bubble) { return polygon_of(frame, bubble); },
        [](const LoneBubble& bubble) { return polygon_of(bubble); });
}

// A picture, stretched over a rectangle of the plane and repeated periodically.
class PlacedPicture {
  public:
    PlacedPicture(const SourcePicture& picture, const Vec2& low, const Vec2& size)
        : picture_(picture), low_(low), size_(size) {
        const double pixel = std::min(size.x() / picture.width(), size.y() / picture.height());
        spacing_ = std::max(pixel, kFinestSpacing * size.maxCoeff());
    }

    // Returns the mean color of the picture over a polygon.
    LinearRgb mean_over(const Polygon& polygon) const {
        LinearRgb sum;
        double total = 0.0;
        visit_polygon_samples(polygon, spacing_, [&](const Vec2& point, double weight) {
            const LinearRgb color = at(point);
            sum = {sum.r + weight * color.r, sum.g + weight * color.g, sum.b + weight * color.b};
            total += weight;
        });
        return total > 0.0 ? LinearRgb{sum.r / total, sum.g / total, sum.b / total}
                           : at(polygon.front());
    }

  private:
    LinearRgb at(const Vec2& point) const {
        const Vec2 position = (point - low_).cwiseQuotient(size_);
        return color_on_white(pixel_of(picture_,
                                       pixel(position.x(), picture_.width()),
                                       pixel(position.y(), picture_.height())));
    }
    // Returns the index of the pixel at `position` along one axis of the repeated picture. The
    // picture has `pixels` pixels along this axis. The unit of `position` is its width or height.
    static int pixel(double position, int pixels) {
        return std::min(static_cast<int>((position - std::floor(position)) * pixels), pixels - 1);
    }

    const SourcePicture& picture_;
    Vec2 low_;
    Vec2 size_;
    double spacing_ = 0.0;
};

// Places a picture on the torus, or on the bounding box of the patch.
PlacedPicture placed(const SourcePicture& picture, const Frame& frame) {
    if (!frame.domain.is_plane()) {
        return {picture, {0.0, 0.0}, {frame.domain.width, frame.domain.height}};
    }
    std::optional<Vec2> low;
    Vec2 high{0.0, 0.0};
    for (const Polygon& polygon : polygons_of(frame)) {
        for (const Vec2& corner : polygon) {
            high = low ? high.cwiseMax(corner).eval() : corner;
            low = low ? low->cwiseMin(corner).eval() : corner;
        }
    }
    const Vec2 origin = low.value_or(Vec2(0.0, 0.0));
    const Vec2 size = low ? Vec2(high - origin) : Vec2(1.0, 1.0);
    return {picture, origin, size};
}

// Returns, for each bubble of frame 1, the mean color of the picture under the bubble.
ColorsByIdentity colors_in_first(const SourcePicture& source, const Frame& first) {
    const PlacedPicture picture = placed(source, first);
    const PerBubble<Polygon> polygons = polygons_of(first);
    const PerBubble<BubbleIdentity> identities = identities_of(first);
    ColorsByIdentity colors;
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        colors.emplace(identities[k], picture.mean_over(polygons[k]));
    }
    return colors;
}

// Returns the color of every bubble of a frame. If `known` contains the bubble, this is its color
// in `known`. Otherwise it is the mean color of the picture under the bubble.
PerBubble<LinearRgb> colors_in_frame(const SourcePicture& source,
                                     const Frame& frame,
                                     const Frame& first,
                                     const ColorsByIdentity& known) {
    std::optional<PlacedPicture> picture;
    const auto color = [&](BubbleIdentity identity, const auto& polygon) {
        const auto found = known.find(identity);
        if (found != known.end()) {
            return found->second;
        }
        if (!picture) {
            picture.emplace(placed(source, first));
        }
        return picture->mean_over(polygon());
    };
    return per_bubble<LinearRgb>(
        frame,
        [&](BubbleId bubble) {
            return color(frame.bubbles[bubble].identity, [&] { return polygon_of(frame, bubble); });
        },
        [&](const LoneBubble& bubble) {
            return color(bubble.identity, [&] { return polygon_of(bubble); });
        });
}

}  // namespace

PerBubble<LinearRgb> picture_colors(const Frame& frame,
                                    const FrameOne& first,
                                    const AlbedoOptions& options) {
    if (!options.picture.is_set()) {
        throw std::invalid_argument("albedo.color_by = \"picture\" needs albedo.picture");
    }
    const SourcePicture& picture = *options.picture.picture;
    if (options.picture_sampling == PictureSampling::EveryFrame) {
        return colors_in_frame(picture, frame, first.frame(), {});
    }
    const auto known = first.colors_under(options.picture.picture,
                                          [&] { return colors_in_first(picture, first.frame()); });
    return colors_in_frame(picture, frame, first.frame(), *known);
}

}  // namespace foam::texgen
