// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/tone_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace foam::texgen {

namespace {

// Two opposite edges of a grid count as visible if the mean difference between their tones is
// large. It must be above kVisibleStep, and above kVisibleRatio times the mean difference between
// adjacent tones.
constexpr double kVisibleStep = 0.02;
constexpr double kVisibleRatio = 3.0;
// The change that blend_edges makes at an edge fades out over this fraction of the width or height
// of the grid.
constexpr double kBlendedPart = 0.125;

// Divides a row or a column of `pixels` pixels into `cells` cells. Returns the index of the first
// pixel of a cell. If `cell` equals `cells`, returns `pixels`.
int first_pixel(int cell, int cells, int pixels) {
    return static_cast<int>(static_cast<std::int64_t>(cell) * pixels / cells);
}

double darkness(const SourcePixel& pixel) {
    return 1.0 - luminance_of(color_on_white(pixel));
}

// A line of tones: a row or a column of a grid.
using Line = std::function<double&(int)>;

void blend_ends(const Line& line, int length) {
    const double half = 0.5 * (line(length - 1) - line(0));
    const int band = std::max(1, static_cast<int>(std::lround(kBlendedPart * length)));
    for (int k = 0; k < std::min(band, length / 2); ++k) {
        const double t = 1.0 - static_cast<double>(k) / band;
        const double change = half * t * t * (3.0 - 2.0 * t);
        line(k) = std::clamp(line(k) + change, 0.0, 1.0);
        line(length - 1 - k) = std::clamp(line(length - 1 - k) - change, 0.0, 1.0);
    }
}

// The differences between the tones of a grid along all of its rows, or along all of its columns.
struct Differences {
    double ends = 0.0;      // sum over the lines of the difference between the two ends of the line
    double adjacent = 0.0;  // sum over the lines of the mean difference between adjacent tones
    int lines = 0;

    void add_line(const std::function<double(int)>& line, int length) {
        ends += std::abs(line(length - 1) - line(0));
        double sum = 0.0;
        for (int k = 0; k + 1 < length; ++k) {
            sum += std::abs(line(k + 1) - line(k));
        }
        adjacent += sum / std::max(length - 1, 1);
        ++lines;
    }
    bool are_visible() const {
        return ends > kVisibleStep * lines && ends > kVisibleRatio * adjacent;
    }
};

}  // namespace

ToneGrid darkness_of(const SourcePicture& picture, int max_cells) {
    const int longest = std::max(picture.width(), picture.height());
    const double scale = std::min(1.0, static_cast<double>(max_cells) / longest);
    const auto cells = [scale](int pixels) {
        return std::max(1, static_cast<int>(std::lround(scale * pixels)));
    };
    ToneGrid grid(cells(picture.width()), cells(picture.height()), 1);
    for (int row = 0; row < grid.height(); ++row) {
        for (int column = 0; column < grid.width(); ++column) {
            const PixelRect box{first_pixel(column, grid.width(), picture.width()),
                                first_pixel(row, grid.height(), picture.height()),
                                first_pixel(column + 1, grid.width(), picture.width()),
                                first_pixel(row + 1, grid.height(), picture.height())};
            grid.pixel(column, row)[0] = mean_over(picture, box, darkness);
        }
    }
    return grid;
}

void stretch_tones(ToneGrid& grid) {
    const auto [smallest, largest] = std::ranges::minmax_element(grid.samples());
    const double low = *smallest;
    const double range = *largest - *smallest;
    for (double& tone : grid.samples()) {
        tone = range > 0.0 ? (tone - low) / range : 0.0;
    }
}

ToneGrid mirrored(const ToneGrid& grid) {
    ToneGrid tiled(2 * grid.width(), 2 * grid.height(), 1);
    for (int row = 0; row < tiled.height(); ++row) {
        for (int column = 0; column < tiled.width(); ++column) {
            const auto from = grid.pixel(std::min(column, tiled.width() - 1 - column),
                                         std::min(row, tiled.height() - 1 - row));
            tiled.pixel(column, row)[0] = from[0];
        }
    }
    return tiled;
}

void blend_edges(ToneGrid& grid) {
    for (int row = 0; row < grid.height(); ++row) {
        blend_ends([&grid, row](int k) -> double& { return grid.pixel(k, row)[0]; }, grid.width());
    }
    for (int column = 0; column < grid.width(); ++column) {
        blend_ends([&grid, column](int k) -> double& { return grid.pixel(column, k)[0]; },
                   grid.height());
    }
}

bool has_visible_edges(const ToneGrid& grid) {
    Differences along_rows;
    for (int row = 0; row < grid.height(); ++row) {
        along_rows.add_line([&grid, row](int k) { return grid.pixel(k, row)[0]; }, grid.width());
    }
    Differences along_columns;
    for (int column = 0; column < grid.width(); ++column) {
        along_columns.add_line([&grid, column](int k) { return grid.pixel(column, k)[0]; },
                               grid.height());
    }
    return along_rows.are_visible() || along_columns.are_visible();
}

}  // namespace foam::texgen
