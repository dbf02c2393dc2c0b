// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/pdf.h"

#include "core/geometry/elementary.h"
#include "texgen/image/color.h"

#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr double kPointsPerMillimeter = 72.0 / 25.4;
// The largest half angle of an arc that a single Bezier curve replaces: 15 degrees.
constexpr double kBezierHalfAngle = std::numbers::pi / 12.0;
// A fixed date, so that the same drawing gives the same bytes.
constexpr const char* kCreationDate = "2000-01-01T00:00:00Z";

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

// Exceptions must not propagate through cairo.
cairo_status_t append(void* text, const unsigned char* data, unsigned size) {
    try {
        static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
        return CAIRO_STATUS_SUCCESS;
    } catch (...) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) {
        throw std::bad_alloc();
    }
    if (status != CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error(std::string("cannot write a PDF: ") +
                                 cairo_status_to_string(status));
    }
}

void set_color(cairo_t* cairo, const std::string& color) {
    const Srgb8 code = parse_color(color);
    cairo_set_source_rgb(cairo, code.r / 255.0, code.g / 255.0, code.b / 255.0);
}

// Adds an arc to the path, as Bezier curves. Let b be the half angle, c the chord length and r the
// radius of the part of the arc that a curve replaces. The handles of the curve then have the
// length 4/3 r tan(b/2) = 2/3 c / (1 + cos b).
void add_arc(cairo_t* cairo, const DrawnArc& arc) {
    const FilmArc film = arc.arc();
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(arc.half_angle) / kBezierHalfAngle)));
    Vec2 tail = arc.tail;
    for (int k = 1; k <= count; ++k) {
        const Vec2 head =
            k == count ? arc.head : arc.tail + point_at(film, static_cast<double>(k) / count);
        const FilmArc part{head - tail, arc.half_angle / count};
        if (part.chord.squaredNorm() > 0.0) {
            const double handle =
                2.0 / 3.0 * part.chord.norm() / (1.0 + ieee::cos(part.half_angle));
            const Vec2 a = tail + handle * tangent_at_tail(part);
            const Vec2 b = head - handle * tangent_at_head(part);
            cairo_curve_to(cairo, a.x(), a.y(), b.x(), b.y(), head.x(), head.y());
        }
        tail = head;
    }
}

void add_path(cairo_t* cairo, const std::vector<Chain>& chains) {
    cairo_new_path(cairo);
    for (const Chain& chain : chains) {
        cairo_move_to(cairo, chain.tail.x(), chain.tail.y());
        for (const DrawnArc& arc : arcs_of(chain)) {
            add_arc(cairo, arc);
        }
        if (chain.is_closed) {
            cairo_close_path(cairo);
        }
    }
}

void draw_shape(cairo_t* cairo, const Shape& shape, const Style& style) {
    add_path(cairo, shape.chains);
    const std::string& fill = shape.fill.empty() ? style.fill : shape.fill;
    if (!fill.empty()) {
        set_color(cairo, fill);
        cairo_fill_preserve(cairo);
    }
    if (!style.stroke.empty() && style.stroke_width > 0.0) {
        set_color(cairo, style.stroke);
        cairo_set_line_width(cairo, style.stroke_width);
        cairo_stroke_preserve(cairo);
    }
}

void draw_layers(cairo_t* cairo, const Drawing& drawing) {
    // Use the coordinates of the drawing: millimeters, with y up.
    cairo_scale(cairo, kPointsPerMillimeter, -kPointsPerMillimeter);
    const Box box = drawing.page_box();
    cairo_translate(cairo, -box.low.x(), -box.high.y());
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    if (!drawing.background.empty()) {
        set_color(cairo, drawing.background);
        cairo_paint(cairo);
    }
    for (const Layer& layer : drawing.layers) {
        for (const Shape& shape : layer.shapes) {
            draw_shape(cairo, shape, layer.style);
        }
    }
}

}  // namespace

std::string to_pdf(const Drawing& drawing) {
    std::string text;
    const Vec2 size = kPointsPerMillimeter * (drawing.page_box().high - drawing.page_box().low);
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &text, size.x(), size.y()),
                          cairo_surface_destroy);
    check(cairo_surface_status(surface.get()));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, kCreationDate);
    const Context context(cairo_create(surface.get()), cairo_destroy);
    draw_layers(context.get(), drawing);
    check(cairo_status(context.get()));
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return text;
}

}  // namespace foam::texgen
