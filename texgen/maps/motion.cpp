// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/motion.h"

#include "core/foam/measure.h"
#include "texgen/maps/boundary_motion.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/grid_positions.h"
#include "texgen/maps/junction_motion.h"
#include "texgen/raster/distance/frame_regions.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// The function junction_motion returns the motion of junctions. Along films, the motion is
// interpolated linearly between junctions. The outline of each bubble is converted to a polygon
// whose corners have these motions. Mean value coordinates interpolate between the corners at the
// pixels of the bubble (boundary_motion.h). Lone bubbles move and grow as circles.

// Each side of the polygon replaces a piece of an arc. kNominalTurn is the nominal angle by which a
// piece turns, in radians; about 10 degrees. The number of pieces of an arc is rounded down, but is
// at least 1. A piece may therefore turn by more, but by less than twice this angle.
constexpr double kNominalTurn = 0.17;

// The motion of a frame's bubbles, in pixels.
class FoamMotion {
  public:
    FoamMotion(FrameLayers& layers)
        : frame_(layers.frame()),
          scale_(pixels_per_unit(layers.grid(), frame_.domain)),
          junctions_(junction_motion(frame_, layers.next())),
          shear_(layers.next().domain.shear_since(frame_.domain)) {}

    // Returns the polygon of a bubble and the motion of the polygon's corners, in pixels. The
    // positions of the corners are relative to the bubble's first junction.
    BoundaryMotion boundary_of(BubbleId bubble) const {
        BoundaryMotion boundary;
        Vec2 tail = Vec2::Zero();
        LatticeOffset offset;
        for (const HalfEdgeId h : frame_.network.around(bubble)) {
            const Vec2 from = motion_at_offset(frame_.network.tail(h), offset);
            offset = offset + frame_.network.offset(h);
            const Vec2 to = motion_at_offset(frame_.network.head(h), offset);
            const FilmArc arc = frame_.arc(h);
            const int pieces =
                std::max(1, static_cast<int>(2.0 * std::abs(arc.half_angle) / kNominalTurn));
            for (int k = 0; k < pieces; ++k) {
                const double part = static_cast<double>(k) / pieces;
                const Vec2 at = part > 0.0 ? Vec2(tail + point_at(arc, part)) : tail;
                boundary.points.push_back(scale_ * at);
                boundary.motions.push_back(scale_ * (from + part * (to - from)));
            }
            tail += arc.chord;
        }
        return boundary;
    }

  private:
    // Returns the motion, in foam units, of the copy of a junction at a lattice offset.
    Vec2 motion_at_offset(JunctionId junction, LatticeOffset offset) const {
        return junctions_[junction] + Vec2(offset.j * shear_, 0.0);
    }

    const Frame& frame_;
    double scale_;                         // pixels per foam unit
    Indexed<JunctionId, Vec2> junctions_;  // motion of junctions, in foam units
    double shear_;                         // change of the shear until the next frame
};

// The motion of a lone bubble. A translation and a scaling map its present circle to its circle in
// the next frame, and its points move by this mapping. If the bubble is not a lone bubble in the
// next frame, its points do not move.
class CircleMotion {
  public:
    CircleMotion(const LoneBubble& bubble, const Frame& next, double scale) : scale_(scale) {
        for (const LoneBubble& candidate : next.lone_bubbles) {
            if (candidate.identity == bubble.identity) {
                displacement_ = candidate.center - bubble.center;
                growth_ = lone_radius(candidate) / lone_radius(bubble) - 1.0;
            }
        }
    }

    // Sets the motions of points. Their positions are relative to the center, in pixels.
    void set_motions(MovingPoints& points) const {
        points.motion_x.clear();
        points.motion_y.clear();
        for (std::size_t k = 0; k < points.x.size(); ++k) {
            points.motion_x.push_back(scale_ * displacement_.x() + growth_ * points.x[k]);
            points.motion_y.push_back(scale_ * displacement_.y() + growth_ * points.y[k]);
        }
    }

  private:
    double scale_;                 // pixels per foam unit
    Vec2 displacement_{0.0, 0.0};  // displacement of the center, in foam units
    double growth_ = 0.0;          // growth of the radius, as a fraction of the radius
};

// Paints motion into the pixels of all bubbles.
class MotionPainter {
  public:
    MotionPainter(FrameLayers& layers, const MotionOptions& options)
        : layers_(layers),
          foam_(layers),
          scale_(pixels_per_unit(layers.grid(), layers.frame().domain)),
          unit_(options.unit == MotionUnit::Image ? layers.grid().width : 1.0),
          up_(options.y == MotionY::Up ? 1.0 : -1.0) {}

    Image<float> paint() {
        const RasterGrid& grid = layers_.grid();
        Image<float> image(grid.width, grid.height, 2);
        const auto paint =
            [&](int, const Region& region, SubpixelPoint translation, PixelRows rows) {
                if (region.kind != RegionKind::Surroundings) {
                    pixels_.rasterize(region, translation, rows);
                    paint_region(region, translation, image.view());
                }
            };
        paint_regions(layers_.frame(), grid, 1, paint);
        return image;
    }

  private:
    void paint_region(const Region& region, SubpixelPoint translation, ImageView<float> image) {
        const std::size_t bubbles = layers_.frame().bubbles.size();
        const std::size_t index = region.id;
        if (index < bubbles) {
            const BoundaryMotion boundary = foam_.boundary_of(id_at<BubbleId>(index));
            const Vec2 first = first_junction(region, translation);
            paint_pixels(
                image, first, [&](MovingPoints& points) { set_motions(boundary, points); });
        } else {
            // Ids of regions: the bubbles, then the surroundings (one id), then the lone bubbles.
            const LoneBubble& lone = layers_.frame().lone_bubbles[index - bubbles - 1];
            const CircleMotion circle(lone, layers_.next(), scale_);
            const Vec2 center = pixel_in_view(layers_.grid(), lone.center);
            paint_pixels(image, center, [&](MovingPoints& points) { circle.set_motions(points); });
        }
    }

    // Returns the position of a bubble's first junction in the image, in pixels. On a torus, it is
    // a whole number of subpixels. The position of a pixel relative to this junction therefore has
    // the same bits on a shifted grid.
    Vec2 first_junction(const Region& region, SubpixelPoint translation) const {
        if (layers_.is_patch()) {
            const Network& network = layers_.frame().network;
            const JunctionId first = network.tail(network.first(id_at<BubbleId>(region.id)));
            return pixel_in_view(layers_.grid(), layers_.frame().positions[first]);
        }
        const SubpixelPoint first = region.first + translation;
        return Vec2(first.x, first.y) / kSubpixel;
    }

    // Paints the pixels that `pixels_` contains, in batches of about a thousand pixels. For each
    // batch, collects the centers of its pixels, relative to `origin`, and calls
    // set_motions(points), which must set the motions at these points.
    template <class SetMotions>
    void paint_pixels(ImageView<float> image, const Vec2& origin, const SetMotions& set_motions) {
        constexpr std::size_t kBatch = 1024;
        const PixelMask& mask = pixels_.mask();
        const PixelBox& box = pixels_.box();
        const auto paint_batch = [&] {
            set_motions(points_);
            paint_points();
        };
        for (int row = mask.rows().begin; row < mask.rows().end; ++row) {
            const int y = box.bottom + row;
            mask.for_each_span(row, [&](int begin, int count) {
                for (int x = box.left + begin; x < box.left + begin + count; ++x) {
                    points_.x.push_back(x + 0.5 - origin.x());
                    points_.y.push_back(y + 0.5 - origin.y());
                    targets_.push_back(image.pixel(wrap(x, image.width()), y).data());
                }
                if (targets_.size() >= kBatch) {
                    paint_batch();
                }
            });
        }
        paint_batch();
    }

    // Writes the motions of the points to their pixels, and removes the points.
    void paint_points() {
        for (std::size_t k = 0; k < targets_.size(); ++k) {
            targets_[k][0] = static_cast<float>(points_.motion_x[k] / unit_);
            targets_[k][1] = static_cast<float>(up_ * points_.motion_y[k] / unit_);
        }
        points_.x.clear();
        points_.y.clear();
        targets_.clear();
    }

    FrameLayers& layers_;
    FoamMotion foam_;
    double scale_;  // pixels per foam unit
    double unit_;   // unit of the samples, in pixels
    double up_;     // 1 if positive y points up, -1 if it points down
    RegionPixels pixels_;
    MovingPoints points_;          // the centers of some pixels
    std::vector<float*> targets_;  // the samples of these pixels
};

}  // namespace

Keys<MotionOptions> motion_keys() {
    constexpr Choices<MotionUnit> kUnits = {
        {{{"image", MotionUnit::Image}, {"px", MotionUnit::Pixels}}}};
    constexpr Choices<MotionY> kDirections = {{{{"up", MotionY::Up}, {"down", MotionY::Down}}}};
    return {key("unit",
                kUnits,
                "unit of floating-point values: fractions of the image width, or pixels; does not "
                "change a PNG",
                &MotionOptions::unit),
            key("y", kDirections, "direction of positive y", &MotionOptions::y),
            key("multiplier",
                RealsOrAuto{1e-6, 10.0, MotionOptions().multiplier},
                "motion at the value 1 of a PNG, as a fraction of the image width; 0 stands for "
                "-multiplier; \"auto\" fits it to the largest motion in the whole animation",
                &MotionOptions::multiplier)
                .in("fraction of the image width")};
}

NumberPixels draw_motion(FrameLayers& layers, const MotionOptions& options) {
    const double width = options.unit == MotionUnit::Image ? 1.0 : layers.grid().width;
    return {MotionPainter(layers, options).paint(),
            -options.multiplier.value * width,
            options.multiplier.value * width};
}

std::string note_on_motion(const MotionOptions& options) {
    return fmt::format(
        "y {}; the largest code of a PNG stands for a motion of {} of the image width",
        options.y == MotionY::Up ? "up" : "down",
        options.multiplier.value);
}

}  // namespace foam::texgen
