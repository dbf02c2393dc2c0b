// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/flat_region.h"

#include <GL/glu.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {

PrintGrid::PrintGrid(double extent) : step_(1.0) {
    // Single precision has 24 significant bits, so that it represents this many steps exactly.
    constexpr double kSteps = 1 << 22;
    while (step_ * kSteps < extent) {
        step_ *= 2.0;
    }
    while (0.5 * step_ * kSteps >= extent && step_ > 1e-12) {
        step_ *= 0.5;
    }
}

Vec2 PrintGrid::operator()(const Vec2& point) const {
    // Adding 0 turns -0 into 0.
    return {std::round(point.x() / step_) * step_ + 0.0,
            std::round(point.y() / step_) * step_ + 0.0};
}

std::uint32_t PointTable::index_of(const Vec2& point) {
    const Vec2 snapped = grid_(point);
    const auto x = static_cast<std::int32_t>(snapped.x() / grid_.step());
    const auto y = static_cast<std::int32_t>(snapped.y() / grid_.step());
    const auto key = edge_between(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    const auto [found, is_new] =
        indices_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (is_new) {
        points_.push_back(snapped);
    }
    return found->second;
}

std::vector<Edge> edges_of(const Ring& ring, PointTable& points) {
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t from = points.index_of(ring[k]);
        const std::uint32_t to = points.index_of(ring[(k + 1) % ring.size()]);
        if (from != to) {
            edges.push_back(edge_between(from, to));
        }
    }
    return edges;
}

std::vector<Edge> without_opposites(std::vector<Edge> edges) {
    std::ranges::sort(edges);
    // Clang 14 does not compile the result of std::ranges::equal_range.
    const auto count = [&](Edge edge) {
        const auto found = std::equal_range(edges.begin(), edges.end(), edge);
        return static_cast<std::size_t>(found.second - found.first);
    };
    std::vector<Edge> kept;
    for (auto edge = edges.begin(); edge != edges.end();) {
        const std::size_t forward = count(*edge);
        const std::size_t backward = count(opposite(*edge));
        kept.insert(kept.end(), forward > backward ? forward - backward : 0, *edge);
        edge += static_cast<std::ptrdiff_t>(forward);
    }
    return kept;
}

namespace {

// Calls visit(point) for the points of each loop of edges, and end() after each loop. At a point
// where several loops meet, they may be joined in any way, because only the number of times that
// the edges wind around a region matters.
template <class Visit, class End>
void visit_loops(std::span<const Edge> edges, const Visit& visit, const End& end) {
    std::vector<bool> used(edges.size(), false);
    const auto unused_from = [&](std::uint32_t start) {
        auto edge = static_cast<std::size_t>(
            std::ranges::lower_bound(edges, edge_between(start, 0)) - edges.begin());
        while (edge < edges.size() && used[edge] && start_of(edges[edge]) == start) {
            ++edge;
        }
        const bool found = edge < edges.size() && start_of(edges[edge]) == start;
        return found ? edge : edges.size();
    };
    for (std::size_t first = 0; first < edges.size(); ++first) {
        std::size_t edge = first;
        bool has_points = false;
        while (edge < edges.size() && !used[edge]) {
            used[edge] = true;
            has_points = true;
            visit(start_of(edges[edge]));
            edge = unused_from(end_of(edges[edge]));
        }
        if (has_points) {
            end();
        }
    }
}

// Receives the triangles from the tessellator of GLU. An exception must not pass through GLU, which
// is written in C, so the first exception is kept. (If on_combine throws, GLU then calls on_error.)
class Tessellation {
  public:
    explicit Tessellation(PointTable& points) : points_(points) {}

    void add_corner(std::uint32_t point) {
        corners_[count_++] = point;
        if (count_ == corners_.size()) {
            const auto& [a, b, c] = corners_;
            // The point where two edges cross is rounded to the grid, where it can coincide with
            // another corner of the triangle. The triangle is then only an edge, which its
            // neighbors share.
            if (a != b && b != c && c != a) {
                triangles.push_back(corners_);
            }
            count_ = 0;
        }
    }
    std::uint32_t add_point(const Vec2& point) { return points_.index_of(point); }

    template <class Action>
    void keep_exception(const Action& action) {
        try {
            action();
        } catch (...) {
            failure = failure ? failure : std::current_exception();
        }
    }

    std::vector<Triangle> triangles;
    std::exception_ptr failure;

  private:
    PointTable& points_;
    Triangle corners_{};
    std::size_t count_ = 0;
};

// GLU passes on pointers, which are not dereferenced. Here, a pointer is an index plus 1. The 1 is
// added because a null pointer from on_combine would mean that on_combine has made no point.
void* as_pointer(std::uint32_t index) {
    return reinterpret_cast<void*>(  // NOLINT(performance-no-int-to-ptr): never dereferenced
        std::uintptr_t{index} + 1);
}

std::uint32_t as_index(const void* pointer) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer) - 1);
}

void on_vertex(void* vertex, void* tessellation) {
    auto& target = *static_cast<Tessellation*>(tessellation);
    target.keep_exception([&] { target.add_corner(as_index(vertex)); });
}

void on_combine(
    const GLdouble* position, void** /*vertices*/, GLfloat*, void** made, void* tessellation) {
    auto& target = *static_cast<Tessellation*>(tessellation);
    target.keep_exception([&] {
        *made = as_pointer(target.add_point({position[0], position[1]}));
    });
}

// This callback makes GLU produce separate triangles instead of fans and strips.
void on_edge_flag(GLboolean /*is_border*/, void* /*tessellation*/) {}

void on_error(GLenum error, void* tessellation) {
    auto& target = *static_cast<Tessellation*>(tessellation);
    target.keep_exception([&] {
        if (error == GLU_OUT_OF_MEMORY) {
            throw std::bad_alloc();
        }
        throw std::logic_error("the tessellator of GLU reports error " + std::to_string(error));
    });
}

using Callback = void (*)();

template <class Function>
Callback as_callback(Function* function) {
    return reinterpret_cast<Callback>(function);
}

struct DeleteTessellator {
    void operator()(GLUtesselator* tessellator) const { gluDeleteTess(tessellator); }
};

std::unique_ptr<GLUtesselator, DeleteTessellator> new_tessellator() {
    std::unique_ptr<GLUtesselator, DeleteTessellator> tessellator(gluNewTess());
    if (!tessellator) {
        throw std::bad_alloc();
    }
    gluTessCallback(tessellator.get(), GLU_TESS_VERTEX_DATA, as_callback(on_vertex));
    gluTessCallback(tessellator.get(), GLU_TESS_COMBINE_DATA, as_callback(on_combine));
    gluTessCallback(tessellator.get(), GLU_TESS_EDGE_FLAG_DATA, as_callback(on_edge_flag));
    gluTessCallback(tessellator.get(), GLU_TESS_ERROR_DATA, as_callback(on_error));
    gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_POSITIVE);
    gluTessNormal(tessellator.get(), 0.0, 0.0, 1.0);
    return tessellator;
}

}  // namespace

std::vector<Triangle> triangles_of(std::span<const Edge> edges, PointTable& points) {
    Tessellation result(points);
    const auto tessellator = new_tessellator();
    GLUtesselator* const tess = tessellator.get();
    gluTessBeginPolygon(tess, &result);
    bool is_open = false;
    const auto visit = [&](std::uint32_t index) {
        if (!std::exchange(is_open, true)) {
            gluTessBeginContour(tess);
        }
        std::array<GLdouble, 3> position{points[index].x(), points[index].y(), 0.0};
        gluTessVertex(tess, position.data(), as_pointer(index));
    };
    const auto end = [&] {
        gluTessEndContour(tess);
        is_open = false;
    };
    visit_loops(edges, visit, end);
    gluTessEndPolygon(tess);
    if (result.failure) {
        std::rethrow_exception(result.failure);
    }
    return std::move(result.triangles);
}

}  // namespace foam::texgen
