// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/contact_sheet.h"

#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/label.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr int kGap = 10;             // pixels between thumbnails, and around all of them
constexpr int kLabelGap = 5;         // pixels above a label
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
    const int line = kLabelGap + kLetterHeight * layout.magnification;
    const int across = first.width() + kGap;
    const int down =
        first.height() + static_cast<int>(thumbnails.front().labels.size()) * line + kGap;
    Image<std::uint8_t> sheet(columns * across + kGap, rows * down + kGap, first.channels());
    std::ranges::fill(sheet.samples(), kBackgroundGray);
    for (int k = 0; k < count; ++k) {
        const Thumbnail& thumbnail = thumbnails[static_cast<std::size_t>(k)];
        const int left = kGap + k % columns * across;
        int bottom = sheet.height() - kGap - k / columns * down - first.height();
        copy(thumbnail.pixels, sheet.view(), left, bottom);
        for (const std::string& label : thumbnail.labels) {
            const std::string text = fitted_label(label, first.width(), layout.magnification);
            const int gap = (first.width() - label_width(text, layout.magnification)) / 2;
            bottom -= line;
            draw_label(sheet.view(), left + gap, bottom, text, kInk, layout.magnification);
        }
    }
    return sheet;
}

}  // namespace foam::texgen
