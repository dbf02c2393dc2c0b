// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/event.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/grid_positions.h"
#include "texgen/maps/mean_bubble.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

// A disk to paint.
struct EventDisk {
    double radius;        // pixels
    float height;         // value at the center
    std::size_t channel;  // channel of the image: 0 red, 1 green, 2 blue
};

// Paints one periodic copy of a disk. `middle` is the center of the copy in subpixels.
void paint_copy(const EventDisk& disk, const Vec2& middle, ImageView<float> image) {
    const Vec2 last(image.width() - 1, image.height() - 1);
    const double reach = std::ceil(disk.radius);
    const Eigen::Array2d pixel = (middle.array() / kSubpixel).floor();
    const Eigen::Array2i low = (pixel - reach).max(0.0).cast<int>();
    const Eigen::Array2i high = (pixel + reach).min(last.array()).cast<int>();
    const double squared_radius = disk.radius * disk.radius * kSubpixel * kSubpixel;
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            const SubpixelPoint center = pixel_center(x, y);
            const double squared = (Vec2(center.x, center.y) - middle).squaredNorm();
            const double inside = std::max(1.0 - squared / squared_radius, 0.0);
            float& value = image.pixel(x, y)[disk.channel];
            value = std::max(value, disk.height * static_cast<float>(inside * inside));
        }
    }
}

}  // namespace

Keys<EventMapOptions> event_map_keys() {
    return {key("radius",
                Reals{0.01, 100.0},
                "radius of the disks in the map `event`, in diameters of a mean bubble of the "
                "seeded foam",
                &EventMapOptions::radius)
                .in("mean bubble diameters of the seeded foam"),
            key("fade",
                Integers{1, kRecordedFrames},
                "number of frames until a disk has faded out",
                &EventMapOptions::fade)
                .in("frames")};
}

NumberPixels draw_event(FrameLayers& layers, const EventMapOptions& options) {
    const Frame& frame = layers.frame();
    const RasterGrid& grid = layers.grid();
    const double diameter = diameter_of(MeanBubble::Seed, frame);
    const double radius = options.radius * diameter * pixels_per_unit(grid, frame.domain);
    Image<float> image(grid.width, grid.height, 3);
    for (const RecordedEvent& event : layers.record().events) {
        const int frames_since = layers.record().frame - event.frame;
        if (frames_since >= options.fade) {
            continue;
        }
        const float height =
            1.0F - static_cast<float>(frames_since) / static_cast<float>(options.fade);
        const EventDisk disk{radius, height, static_cast<std::size_t>(event.kind)};
        for_each_copy(grid, frame.domain, event.position, radius, [&](const Vec2& middle) {
            paint_copy(disk, middle, image.view());
        });
    }
    return {std::move(image), 0.0, 1.0};
}

}  // namespace foam::texgen
