#include "texgen/raster/coverage.h"

#include <algorithm>

namespace foam::texgen {

namespace {

constexpr std::size_t kFlagsPerWord = 64;

// Reads all before it writes any, so that the channels are taken several at once.
template <class Sum>
void add_times(typename Sum::value_type factor, const Sum& value, Sum& to) {
    Sum sum = to;
    for (std::size_t c = 0; c < sum.size(); ++c) {
        sum[c] += factor * value[c];
    }
    to = sum;
}

// Sets the flags from one to another, both included.
void set_flags(std::uint64_t* flags, std::size_t from, std::size_t to) {
    const std::size_t word = from / kFlagsPerWord;
    const std::size_t last = to / kFlagsPerWord;
    const std::uint64_t head = ~std::uint64_t{0} << from % kFlagsPerWord;
    const std::uint64_t tail = ~std::uint64_t{0} >> (kFlagsPerWord - 1 - to % kFlagsPerWord);
    if (word == last) {
        flags[word] |= head & tail;
        return;
    }
    flags[word] |= head;
    std::fill(flags + word + 1, flags + last, ~std::uint64_t{0});
    flags[last] |= tail;
}

}  // namespace

template <class Sums>
Coverage<Sums>::Coverage(int width, int rows, RowKind kind)
    : width_(width),
      kind_(kind),
      stride_(static_cast<std::size_t>(width) + 1),
      words_(stride_ / kFlagsPerWord + 1),
      differences_(stride_ * static_cast<std::size_t>(rows)),
      touched_(words_ * static_cast<std::size_t>(rows)),
      walk_(rows),
      starts_(static_cast<std::size_t>(rows)) {}

template <class Sums>
void Coverage<Sums>::add(const CellArc& arc, SubpixelPoint translation, const Step& step) {
    walk_.split(arc, translation);
    for (const ArcWalk::Run& run : walk_.runs()) {
        const std::int32_t begin = walk_.column(run.begin);
        const std::int32_t end = walk_.column(run.end - 1);
        const auto [left, right] = std::minmax(begin, end);
        if (left >= 0 && right < width_) [[likely]] {
            touch(static_cast<std::size_t>(run.row), left, right);
            add_run(run, step);
        } else {
            add_outside(run, step);
        }
        if (step.goes_around) [[unlikely]] {
            add_around(run, step);
        }
    }
}

// From left to right: what a part leaves out of its pixel is in the next one's sum.
template <class Sums>
inline void Coverage<Sums>::add_run(const ArcWalk::Run& run, const Step& step) {
    const std::size_t parts = run.end - run.begin;
    const std::size_t first = walk_.is_leftward() ? run.end - 1 : run.begin;
    const std::ptrdiff_t next = walk_.is_leftward() ? -1 : 1;
    Sum* to = &differences_[static_cast<std::size_t>(run.row) * stride_ +
                            static_cast<std::size_t>(walk_.column(first))];
    typename Sums::Number left_out = 0;
    for (std::size_t k = 0; k < parts; ++k) {
        const std::size_t part =
            first + static_cast<std::size_t>(next * static_cast<std::ptrdiff_t>(k));
        const auto on_left = Sums::of_area(walk_.on_left(part));
        add_times(Sums::of_area(walk_.whole(part)) - on_left + left_out, step.across, to[k]);
        left_out = on_left;
    }
    add_times(left_out, step.across, to[parts]);
}

// An arc in another period of its sides' outlines.
template <class Sums>
void Coverage<Sums>::add_around(const ArcWalk::Run& run, const Step& step) {
    for (std::size_t part = run.begin; part < run.end; ++part) {
        add_times(Sums::of_area(-walk_.whole(part)),
                  step.around,
                  starts_[static_cast<std::size_t>(run.row)]);
    }
}

// Parts beyond the borders, one by one.
template <class Sums>
void Coverage<Sums>::add_outside(const ArcWalk::Run& run, const Step& step) {
    const auto row = static_cast<std::size_t>(run.row);
    for (std::size_t part = run.begin; part < run.end; ++part) {
        const std::int32_t periods = floor_div(walk_.column(part), width_);
        const bool is_ring = kind_ == RowKind::Ring;
        const std::int32_t times = is_ring ? -periods : periods < 0 ? 1 : 0;
        const auto whole = Sums::of_area(walk_.whole(part));
        const auto on_left = Sums::of_area(walk_.on_left(part));
        add_times(Sums::of_value(times) * whole, step.across, starts_[row]);
        if (is_ring || periods == 0) {
            const std::int32_t column = walk_.column(part) - periods * width_;
            touch(row, column, column);
            Sum* to = &differences_[row * stride_ + static_cast<std::size_t>(column)];
            add_times(whole - on_left, step.across, to[0]);
            add_times(on_left, step.across, to[1]);
        }
    }
}

template <class Sums>
inline void Coverage<Sums>::touch(std::size_t row, std::int32_t left, std::int32_t right) {
    set_flags(&touched_[row * words_],
              static_cast<std::size_t>(left),
              static_cast<std::size_t>(right) + 1);
}

template class Coverage<ExactSums<1>>;
template class Coverage<ExactSums<2>>;
template class Coverage<ExactSums<3>>;
template class Coverage<ExactSums<4>>;
template class Coverage<SmallSums<1>>;
template class Coverage<SmallSums<2>>;
template class Coverage<SmallSums<3>>;
template class Coverage<SmallSums<4>>;

}  // namespace foam::texgen
