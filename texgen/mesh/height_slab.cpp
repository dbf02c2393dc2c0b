// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/height_slab.h"

#include <cmath>
#include <cstdint>

namespace foam::texgen {

namespace {

std::uint32_t index_at(const HeightField& field, std::size_t column, std::size_t row) {
    return static_cast<std::uint32_t>(row * field.x.size() + column);
}

void add_surface(const HeightField& field, Mesh& mesh) {
    for (std::size_t row = 0; row < field.y.size(); ++row) {
        for (std::size_t column = 0; column < field.x.size(); ++column) {
            mesh.positions.push_back({field.x[column], field.y[row], field.at(column, row)});
        }
    }
    for (std::size_t row = 0; row + 1 < field.y.size(); ++row) {
        for (std::size_t column = 0; column + 1 < field.x.size(); ++column) {
            const std::uint32_t a = index_at(field, column, row);
            const std::uint32_t b = index_at(field, column + 1, row);
            const std::uint32_t c = index_at(field, column + 1, row + 1);
            const std::uint32_t d = index_at(field, column, row + 1);
            if (std::abs(field.z[a] - field.z[c]) <= std::abs(field.z[b] - field.z[d])) {
                mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, b, c}, {a, c, d}});
            } else {
                mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, b, d}, {b, c, d}});
            }
        }
    }
}

// Returns the points on the border of the surface, counter-clockwise.
std::vector<std::uint32_t> border_of(const HeightField& field) {
    const std::size_t right = field.x.size() - 1;
    const std::size_t top = field.y.size() - 1;
    std::vector<std::uint32_t> border;
    for (std::size_t column = 0; column < right; ++column) {
        border.push_back(index_at(field, column, 0));
    }
    for (std::size_t row = 0; row < top; ++row) {
        border.push_back(index_at(field, right, row));
    }
    for (std::size_t column = right; column > 0; --column) {
        border.push_back(index_at(field, column, top));
    }
    for (std::size_t row = top; row > 0; --row) {
        border.push_back(index_at(field, 0, row));
    }
    return border;
}

// Adds the sides, and the bottom as a fan around its center.
void add_sides_and_bottom(const HeightField& field, Mesh& mesh) {
    const std::vector<std::uint32_t> border = border_of(field);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t top : border) {
        const Point3 point = mesh.positions[top];
        mesh.positions.push_back({point[0], point[1], 0.0F});
    }
    const auto center = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back({0.5F * (field.x.front() + field.x.back()),
                              0.5F * (field.y.front() + field.y.back()),
                              0.0F});
    for (std::size_t k = 0; k < border.size(); ++k) {
        const std::size_t next = (k + 1) % border.size();
        const auto a = first + static_cast<std::uint32_t>(k);
        const auto b = first + static_cast<std::uint32_t>(next);
        mesh.triangles.insert(
            mesh.triangles.end(),
            {Triangle{a, b, border[next]}, {a, border[next], border[k]}, {center, b, a}});
    }
}

}  // namespace

std::size_t slab_triangles(std::size_t columns, std::size_t rows) {
    return 2 * (columns - 1) * (rows - 1) + 6 * (columns - 1 + rows - 1);
}

Mesh height_slab(const HeightField& field) {
    const std::size_t columns = field.x.size();
    const std::size_t rows = field.y.size();
    Mesh mesh;
    mesh.positions.reserve(columns * rows + 2 * (columns + rows));
    mesh.triangles.reserve(slab_triangles(columns, rows));
    add_surface(field, mesh);
    add_sides_and_bottom(field, mesh);
    return mesh;
}

}  // namespace foam::texgen
