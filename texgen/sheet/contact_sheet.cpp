// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/contact_sheet.h"

#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/label.h"
#include "texgen/sheet/spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace foam::texgen {

namespace {

constexpr int kGap = 10;             // pixels between thumbnails, and around all of them
constexpr int kLabelGap = 5;         // pixels above each line of a label
constexpr std::uint8_t kInk = 0xb4;  // gray value of labels
constexpr double kAspect = 1.5;      // approximate width of a sheet divided by its height

// Returns the number of columns with which the aspect ratio of a sheet is about kAspect.
int columns_for(std::size_t count, const Image<std::uint8_t>& thumbnail) {
    const double square = static_cast<double>(count) * thumbnail.height() / thumbnail.width();
    const auto columns = static_cast<int>(std::lround(std::sqrt(kAspect * square)));
    return std::clamp(columns, 1, static_cast<int>(count));
}

void copy(const Image<std::uint8_t>& from, ImageView<std::uint8_t> to, int left, int bottom) {
    for (int y = 0; y < from.height(); ++y) {
        std::ranges::copy(from.row(y), to.pixel(left, bottom + y).data());
    }
}

// A line of a label below a thumbnail: a text, and colors that are drawn after the text.
struct Line {
    std::string text;
    std::vector<Srgb8> colors;
};

// Arranges labels in lines, and draws these lines. If `width` is less than the width of a letter,
// each line has at most one letter; otherwise, no line is wider than `width`.
class LabelWriter {
  public:
    LabelWriter(int width, int magnification) : width_(width), magnification_(magnification) {}

    int line_height() const { return kLabelGap + letter_height(); }

    std::vector<Line> lines_of(const std::vector<ThumbnailLabel>& labels) const {
        std::vector<Line> lines;
        for (const ThumbnailLabel& label : labels) {
            for (std::string& text : wrapped_label(label.text, width_, magnification_)) {
                lines.push_back({std::move(text), {}});
            }
            if (width_of({lines.back().text, label.colors}) > width_) {
                lines.emplace_back();
            }
            lines.back().colors = spread(label.colors, static_cast<std::size_t>(width_));
        }
        return lines;
    }

    // Draws a line whose lower left corner is the pixel (left, bottom). Lines are centered.
    void draw(ImageView<std::uint8_t> sheet, int left, int bottom, const Line& line) const {
        left += (width_ - width_of(line)) / 2;
        draw_label(sheet, left, bottom, line.text, kInk, magnification_);
        left += width_of({line.text, {}}) + gap_of(line);
        for (const Srgb8 color : line.colors) {
            fill(sheet, left, bottom, color_width(line.colors.size()), color);
            left += color_width(line.colors.size());
        }
    }

  private:
    int letter_height() const { return kLetterHeight * magnification_; }

    // Returns the width at which each of `count` colors is drawn. A color is a square as high as a
    // letter, or narrower if the squares do not fit on one line.
    int color_width(std::size_t count) const {
        return std::clamp(width_ / std::max(static_cast<int>(count), 1), 1, letter_height());
    }

    // Returns the space between the text and the colors of a line.
    int gap_of(const Line& line) const {
        return line.text.empty() || line.colors.empty() ? 0 : kLetterWidth * magnification_;
    }

    int width_of(const Line& line) const {
        return label_width(line.text, magnification_) + gap_of(line) +
               static_cast<int>(line.colors.size()) * color_width(line.colors.size());
    }

    void fill(ImageView<std::uint8_t> sheet, int left, int bottom, int width, Srgb8 color) const {
        for (int y = bottom; y < bottom + letter_height(); ++y) {
            for (int x = left; x < left + width; ++x) {
                std::ranges::copy(std::array{color.r, color.g, color.b}, sheet.pixel(x, y).data());
            }
        }
    }

    int width_;
    int magnification_;
};

}  // namespace

Image<std::uint8_t> contact_sheet(std::span<const Thumbnail> thumbnails,
                                  const ContactSheetLayout& layout) {
    if (thumbnails.empty()) {
        throw std::invalid_argument("a contact sheet needs at least one frame");
    }
    const Image<std::uint8_t>& first = thumbnails.front().pixels;
    const auto count = static_cast<int>(thumbnails.size());
    const int columns = layout.columns > 0 ? std::min(layout.columns, count)
                                           : columns_for(thumbnails.size(), first);
    const int rows = (count + columns - 1) / columns;
    const LabelWriter writer(first.width(), layout.magnification);
    std::vector<std::vector<Line>> lines;
    std::size_t most_lines = 0;
    for (const Thumbnail& thumbnail : thumbnails) {
        lines.push_back(writer.lines_of(thumbnail.labels));
        most_lines = std::max(most_lines, lines.back().size());
    }
    const int cell_width = first.width() + kGap;
    const int cell_height =
        first.height() + static_cast<int>(most_lines) * writer.line_height() + kGap;
    Image<std::uint8_t> sheet(
        columns * cell_width + kGap, rows * cell_height + kGap, first.channels());
    std::ranges::fill(sheet.samples(), kBackgroundGray);
    for (int k = 0; k < count; ++k) {
        const int left = kGap + k % columns * cell_width;
        int bottom = sheet.height() - kGap - k / columns * cell_height - first.height();
        copy(thumbnails[static_cast<std::size_t>(k)].pixels, sheet.view(), left, bottom);
        for (const Line& line : lines[static_cast<std::size_t>(k)]) {
            bottom -= writer.line_height();
            writer.draw(sheet.view(), left, bottom, line);
        }
    }
    return sheet;
}

}  // namespace foam::texgen
