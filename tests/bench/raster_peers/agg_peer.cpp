// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/peers.h"

#include <agg_pixfmt_rgb.h>
#include <agg_rasterizer_compound_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_bin.h>
#include <agg_scanline_u.h>
#include <agg_span_allocator.h>

#include <memory>

namespace foam::bench {

namespace {

struct Styles {
    std::vector<agg::rgba8> colors;

    static bool is_solid(unsigned) { return true; }
    const agg::rgba8& color(unsigned style) const { return colors[style]; }
    static void generate_span(agg::rgba8*, int, int, unsigned, unsigned) {}
};

// Draws each film once. The styles (fill colors) of its two sides are the bubbles beside it. AGG's
// compound rasterizer is made for shapes that share edges.
class AggPainter {
  public:
    explicit AggPainter(int side)
        : image_(side, side, 3),
          buffer_(image_.samples().data(),
                  static_cast<unsigned>(side),
                  static_cast<unsigned>(side),
                  3 * side),
          format_(buffer_),
          renderer_(format_) {
        rasterizer_.clip_box(0, 0, side, side);
    }

    void fill(const Scene& scene) {
        styles_.colors.clear();
        for (const auto& color : scene.colors) {
            styles_.colors.emplace_back(color[0], color[1], color[2]);
        }
        std::ranges::fill(image_.samples(), std::uint8_t{0});
        rasterizer_.reset();
        rasterizer_.layer_order(agg::layer_unsorted);
        for (const Scene::Film& film : scene.films) {
            rasterizer_.styles(film.left, film.right);
            rasterizer_.move_to_d(film.line.front().x(), film.line.front().y());
            for (std::size_t k = 1; k < film.line.size(); ++k) {
                rasterizer_.line_to_d(film.line[k].x(), film.line[k].y());
            }
        }
        agg::render_scanlines_compound(
            rasterizer_, line_, binary_line_, renderer_, spans_, styles_);
    }

    const texgen::Image<std::uint8_t>& image() const { return image_; }

  private:
    texgen::Image<std::uint8_t> image_;
    agg::rendering_buffer buffer_;
    agg::pixfmt_rgb24 format_;
    agg::renderer_base<agg::pixfmt_rgb24> renderer_;
    agg::rasterizer_compound_aa<agg::rasterizer_sl_clip_dbl> rasterizer_;
    agg::scanline_u8 line_;
    agg::scanline_bin binary_line_;
    agg::span_allocator<agg::rgba8> spans_;
    Styles styles_;
};

}  // namespace

Painter agg_painter(int side) {
    const auto agg = std::make_shared<AggPainter>(side);
    return {
        "AGG", [agg](const Scene& scene) { agg->fill(scene); }, {}, [agg] { return agg->image(); }};
}

}  // namespace foam::bench
