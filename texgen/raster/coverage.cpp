#include "texgen/raster/coverage.h"

namespace foam::texgen {

namespace {

constexpr std::size_t kFlagsPerWord = 64;
constexpr std::int64_t kFullWidth = std::int64_t{2} * kSubpixel;  // of a pixel, as areas count

}  // namespace

template <std::size_t Channels>
Coverage<Channels>::Coverage(int width, int rows, RowKind kind)
    : width_(width),
      rows_(rows),
      kind_(kind),
      stride_(static_cast<std::size_t>(width) + 1),
      words_(stride_ / kFlagsPerWord + 1),
      differences_(stride_ * static_cast<std::size_t>(rows)),
      touched_(words_ * static_cast<std::size_t>(rows)),
      starts_(static_cast<std::size_t>(rows)) {}

template <std::size_t Channels>
void Coverage<Channels>::add(std::span<const SubpixelPoint> chain,
                             SubpixelPoint translation,
                             const Value& value) {
    const auto add_to_band = [&](const PixelPart& part) { add_part(part, value); };
    EdgeWalk(rows_, add_to_band).walk(chain, translation);
}

template <std::size_t Channels>
void Coverage<Channels>::add_part(const PixelPart& part, const Value& value) {
    std::int32_t column = part.column;
    if (column < 0 || column >= width_) {
        const std::int32_t periods = floor_div(column, width_);
        if (kind_ == RowKind::Line) {
            add_past_border(part.row, column < 0 ? -part.height : 0, value);
            return;
        }
        add_past_border(part.row, std::int64_t{periods} * part.height, value);
        column -= periods * width_;
    }
    const auto x = static_cast<std::size_t>(column);
    const auto row = static_cast<std::size_t>(part.row);
    const std::int64_t here = part.height * kFullWidth - part.area;
    Sum* differences = &differences_[row * stride_ + x];
    for (std::size_t c = 0; c < Channels; ++c) {
        differences[0][c] += here * value[c];
        differences[1][c] += part.area * value[c];
    }
    touch_two(row * words_, x);
}

template <std::size_t Channels>
void Coverage<Channels>::touch_two(std::size_t row_words, std::size_t x) {
    const std::size_t word = row_words + x / kFlagsPerWord;
    const std::size_t bit = x % kFlagsPerWord;
    touched_[word] |= std::uint64_t{3} << bit;
    if (bit == kFlagsPerWord - 1) {
        touched_[word + 1] |= 1;
    }
}

template <std::size_t Channels>
void Coverage<Channels>::add_past_border(std::int32_t row,
                                         std::int64_t height,
                                         const Value& value) {
    Sum& start = starts_[static_cast<std::size_t>(row)];
    for (std::size_t c = 0; c < Channels; ++c) {
        start[c] -= height * kFullWidth * value[c];
    }
}

template class Coverage<1>;
template class Coverage<2>;
template class Coverage<3>;
template class Coverage<4>;

}  // namespace foam::texgen
