// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/peers.h"

#include <cairo.h>

#include <cstddef>
#include <memory>

namespace foam::bench {

namespace {

// Draws a scene with cairo. The colors of cells are added to a black image (operator ADD), so that
// no background is visible between adjacent cells. Films are drawn over the cells.
class CairoPainter {
  public:
    CairoPainter(int side, cairo_antialias_t antialias)
        : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, side, side)),
          context_(cairo_create(surface_.get())) {
        cairo_set_antialias(context_.get(), antialias);
        cairo_set_line_width(context_.get(), kFilmWidth);
        cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);  // junctions have no gaps
    }

    void fill(const Scene& scene) {
        cairo_t* cr = context_.get();
        cairo_set_operator(cr, CAIRO_OPERATOR_SOURCE);
        cairo_set_source_rgb(cr, 0.0, 0.0, 0.0);
        cairo_paint(cr);
        cairo_set_operator(cr, CAIRO_OPERATOR_ADD);
        for (const Scene::Cell& cell : scene.cells) {
            const auto& color = scene.colors[cell.bubble];
            cairo_set_source_rgb(cr, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
            trace(cell.outline);
            cairo_fill(cr);
        }
    }

    void stroke(const Scene& scene) {
        cairo_t* cr = context_.get();
        cairo_set_operator(cr, CAIRO_OPERATOR_OVER);
        cairo_set_source_rgb(cr, 1.0, 1.0, 1.0);
        for (const Scene::Film& film : scene.films) {
            trace(film.line);
            cairo_stroke(cr);  // faster than one path of all films
        }
    }

    texgen::Image<std::uint8_t> image() const {
        cairo_surface_flush(surface_.get());
        constexpr std::ptrdiff_t kPixelBytes = 4;
        const int side = cairo_image_surface_get_width(surface_.get());
        const unsigned char* data = cairo_image_surface_get_data(surface_.get());
        const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_.get());
        texgen::Image<std::uint8_t> copy(side, side, 3);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                // The bytes of a pixel are blue, green, red, unused.
                const unsigned char* pixel = data + y * stride + kPixelBytes * x;
                const auto to = copy.pixel(x, y);
                std::reverse_copy(pixel, pixel + 3, to.begin());
            }
        }
        return copy;
    }

  private:
    struct Free {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    void trace(const Polyline& line) const {
        for (const Vec2& point : line) {
            cairo_line_to(context_.get(), point.x(), point.y());
        }
    }

    std::unique_ptr<cairo_surface_t, Free> surface_;
    std::unique_ptr<cairo_t, Free> context_;
};

Painter painter(const std::string& name, int side, cairo_antialias_t antialias) {
    const auto cairo = std::make_shared<CairoPainter>(side, antialias);
    const auto fill_and_films = [cairo](const Scene& scene) {
        cairo->fill(scene);
        cairo->stroke(scene);
    };
    return {name,
            [cairo](const Scene& scene) { cairo->fill(scene); },
            fill_and_films,
            [cairo] { return cairo->image(); }};
}

}  // namespace

std::vector<Painter> cairo_painters(int side) {
    return {painter("cairo", side, CAIRO_ANTIALIAS_DEFAULT),
            painter("cairo, fast", side, CAIRO_ANTIALIAS_FAST)};
}

}  // namespace foam::bench
