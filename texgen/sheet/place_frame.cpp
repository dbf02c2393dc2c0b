// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/place_frame.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace foam::texgen {

namespace {

// Returns the row of a frame that is copied to the row `position` of its cell in the sheet.
// Position 0 is the first row of the frame in the cell; the gutter has the positions below 0 and
// from `extent` on. The result is in [0, extent). The same holds for columns.
int source_of(int position, int extent, Gutter gutter) {
    if (gutter == Gutter::Edge) {
        return std::clamp(position, 0, extent - 1);
    }
    const int rest = position % extent;
    return rest < 0 ? rest + extent : rest;
}

// Writes row y of a frame, with a gutter of `margin` pixels on both sides, to `output`. Row y may
// be above or below the frame, in the gutter.
template <class Sample>
void copy_row(ImageView<const Sample> frame, int y, int margin, Gutter gutter, Sample* output) {
    const int source_row = source_of(y, frame.height(), gutter);
    const auto channels = static_cast<std::size_t>(frame.channels());
    for (int x = -margin; x < 0; ++x) {
        std::ranges::copy(frame.pixel(source_of(x, frame.width(), gutter), source_row), output);
        output += channels;
    }
    std::ranges::copy(frame.row(source_row), output);
    output += frame.row_samples();
    for (int x = frame.width(); x < frame.width() + margin; ++x) {
        std::ranges::copy(frame.pixel(source_of(x, frame.width(), gutter), source_row), output);
        output += channels;
    }
}

}  // namespace

template <class Sample>
void place_frame(ImageView<Sample> sheet,
                 const SheetLayout& layout,
                 int number,
                 ImageView<const Sample> frame,
                 Gutter gutter) {
    assert(sheet.channels() == frame.channels());
    assert(sheet.width() == layout.width() && sheet.height() == layout.height());
    assert(frame.width() == layout.frame_width && frame.height() == layout.frame_height);
    const int left = number % layout.columns * layout.cell_width();
    const int bottom =
        sheet.height() - (number / layout.columns + 1) * layout.cell_height() + layout.gutter;
    for (int y = -layout.gutter; y < frame.height() + layout.gutter; ++y) {
        Sample* const to = sheet.pixel(left, bottom + y).data();
        copy_row(frame, y, layout.gutter, gutter, to);
    }
}

template void place_frame(ImageView<std::uint8_t> sheet,
                          const SheetLayout& layout,
                          int number,
                          ImageView<const std::uint8_t> frame,
                          Gutter gutter);
template void place_frame(ImageView<std::uint16_t> sheet,
                          const SheetLayout& layout,
                          int number,
                          ImageView<const std::uint16_t> frame,
                          Gutter gutter);
template void place_frame(ImageView<std::uint32_t> sheet,
                          const SheetLayout& layout,
                          int number,
                          ImageView<const std::uint32_t> frame,
                          Gutter gutter);
template void place_frame(ImageView<float> sheet,
                          const SheetLayout& layout,
                          int number,
                          ImageView<const float> frame,
                          Gutter gutter);

}  // namespace foam::texgen
