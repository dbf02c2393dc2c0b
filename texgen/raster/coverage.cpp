#include "texgen/raster/coverage.h"

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr std::size_t kFlagsPerWord = 64;
constexpr std::int32_t kFullWidth = 2 * kSubpixel;  // of a pixel, as areas count

// Reads all before it writes any, so that the channels are taken several at once.
template <std::size_t Lanes>
void add_times(double factor,
               const std::array<double, Lanes>& value,
               std::array<double, Lanes>& to) {
    std::array<double, Lanes> sum = to;
    for (std::size_t c = 0; c < Lanes; ++c) {
        sum[c] += factor * value[c];
    }
    to = sum;
}

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
inline void Coverage<Channels>::touch_two(std::size_t row_words, std::size_t x) {
    const std::size_t word = row_words + x / kFlagsPerWord;
    const std::size_t bit = x % kFlagsPerWord;
    touched_[word] |= std::uint64_t{3} << bit;
    if (bit == kFlagsPerWord - 1) {
        touched_[word + 1] |= 1;
    }
}

template <std::size_t Channels>
inline void Coverage<Channels>::add_part(const PixelPart& part, const Sum& value) {
    std::int32_t column = part.column;
    if (static_cast<std::uint32_t>(column) >= static_cast<std::uint32_t>(width_)) [[unlikely]] {
        column = wrap_part(part, value);
        if (column < 0) {
            return;
        }
    }
    const auto x = static_cast<std::size_t>(column);
    const auto row = static_cast<std::size_t>(part.row);
    const double here = part.height * kFullWidth - part.area;
    const double right = part.area;
    Sum* differences = &differences_[row * stride_ + x];
    add_times(here, value, differences[0]);
    add_times(right, value, differences[1]);
    touch_two(row * words_, x);
}

template <std::size_t Channels>
void Coverage<Channels>::add(std::span<const SubpixelPoint> chain,
                             std::size_t begin,
                             std::size_t end,
                             SubpixelPoint translation,
                             const Value& value) {
    Sum values{};
    std::copy(value.begin(), value.end(), values.begin());
    const auto add_to_band = [&](const PixelPart& part) { add_part(part, values); };
    EdgeWalk(rows_, add_to_band).walk(chain, begin, end, translation);
}

// The column in the row's own period, or -1 in the plane; what is past the border is added.
template <std::size_t Channels>
std::int32_t Coverage<Channels>::wrap_part(const PixelPart& part, const Sum& value) {
    const std::int32_t periods = floor_div(part.column, width_);
    if (kind_ == RowKind::Line) {
        add_past_border(part.row, part.column < 0 ? -part.height : 0, value);
        return -1;
    }
    add_past_border(part.row, static_cast<double>(periods) * part.height, value);
    return part.column - periods * width_;
}

template <std::size_t Channels>
void Coverage<Channels>::add_past_border(std::int32_t row, double height, const Sum& value) {
    Sum& start = starts_[static_cast<std::size_t>(row)];
    for (std::size_t c = 0; c < value.size(); ++c) {
        start[c] -= height * kFullWidth * value[c];
    }
}

template class Coverage<1>;
template class Coverage<2>;
template class Coverage<3>;
template class Coverage<4>;

}  // namespace foam::texgen
