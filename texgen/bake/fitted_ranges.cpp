// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/fitted_ranges.h"

#include "core/geometry/elementary.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/bake/bounded_workers.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/number_extent.h"
#include "texgen/preset/drawn_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

// The factor that allows for peaks between the pixels of the reduced images.
constexpr double kMargin = 1.01;

// If no number of a map exceeds this share of the range before the fit, the numbers are taken for
// rounding errors, and the range is not changed. An example is the growth of a foam that does not
// change.
constexpr double kRoundingShare = 1e-9;

// A map with an automatic range, and how large its numbers have been so far.
struct MeasuredMap {
    const Map* map = nullptr;
    // The largest absolute value of its numbers so far, divided by the upper end of its range
    // before the fit. This range follows from the AutoReal::value that the preset has before the
    // fit.
    double largest = 0.0;
};

// Draws the maps with automatic ranges at a reduced size and measures their numbers.
class RangeMeter {
  public:
    explicit RangeMeter(const Preset& preset) : image_(reduced_image(preset, kMeasuredSide)) {
        for (const Map* const map : maps_with_automatic_ranges(preset)) {
            maps_.push_back({map});
            names_.emplace_back(map->name);
        }
    }

    bool needs_next() const {
        return std::ranges::any_of(maps_,
                                   [](const MeasuredMap& one) { return one.map->needs_next; });
    }

    /// Measures a frame. May be called from several threads at once.
    void measure(const SimulatedFrame& shown) {
        measure_state(shown, shown.view);
        if (shown.fading_in.frame) {
            measure_state(shown.fading_in, shown.view);
        }
    }

    const std::vector<MeasuredMap>& maps() const { return maps_; }

  private:
    void measure_state(const DrawnState& state, const std::optional<View>& view) {
        if (state.frame->bubbles.size() == 0 && state.frame->lone_bubbles.empty()) {
            return;  // without bubbles there is nothing to measure
        }
        const MapOptions& options = image_.options;
        FrameLayers layers(state.input(distance_needs(names_, options)), image_.grid(view), 1);
        for (MeasuredMap& one : maps_) {
            const MapImage image = one.map->draw(layers, options);
            const NumberPixels& numbers = std::get<NumberPixels>(image);
            const NumberExtent extent = extent_of(numbers);
            const double largest = std::max(std::abs(extent.smallest), std::abs(extent.largest));
            const std::scoped_lock lock(mutex_);
            one.largest = std::max(one.largest, largest / numbers.high);
        }
    }

    std::mutex mutex_;  // guards MeasuredMap::largest
    std::vector<MeasuredMap> maps_;
    ReducedImage image_;
    std::vector<std::string> names_;
};

}  // namespace

// A map needs its range if it is stored as codes. In every format, a map in a packing also needs
// it, because a packing stores codes or fractions of a range.
std::vector<const Map*> maps_with_automatic_ranges(const Preset& preset) {
    const FilePattern pattern(preset);
    std::vector<const Map*> maps;
    if (pattern.is_vector()) {
        return maps;
    }
    const ImageFormat& format = pattern.format();
    for (const DrawnImage& image : drawn_images(preset)) {
        if (format.samples != FormatSamples::Codes && image.map() != nullptr) {
            continue;
        }
        for (const Map* const map : image.sources()) {
            const AutoReal* const range = range_option_of(*map, preset.maps);
            const bool is_known = std::ranges::find(maps, map) != maps.end();
            if (range != nullptr && range->is_automatic && !is_known) {
                maps.push_back(map);
            }
        }
    }
    return maps;
}

bool has_automatic_ranges(const Preset& preset) {
    return !maps_with_automatic_ranges(preset).empty();
}

RunOutcome fit_automatic_ranges(Preset& preset,
                                const FrameSource& source,
                                const std::vector<int>& frames,
                                int threads,
                                const ProgressCallback& on_progress) {
    RangeMeter ranges(preset);
    ProgressMeter progress(Phase::Ranges, static_cast<int>(frames.size()), on_progress);
    const NextFrames next = ranges.needs_next() ? NextFrames::Included : NextFrames::Omitted;
    BoundedWorkers workers(thread_count(threads) - 1);
    const auto measure = [&](const SimulatedFrame& shown) {
        progress.begin();
        workers.submit([shown, &ranges, &progress] {
            ranges.measure(shown);
            progress.add(shown);
        });
    };
    RunOutcome outcome = source(frames, next, measure, progress.for_source());
    workers.finish();
    if (outcome.status == RunStatus::Complete) {
        for (const MeasuredMap& one : ranges.maps()) {
            AutoReal& range = *range_option_of(*one.map, preset.maps);
            range.value = fitted_range(range.value, one.largest);
        }
    }
    return outcome;
}

double fitted_range(double range, double largest) {
    return largest > kRoundingShare ? rounded_up(kMargin * largest * range) : range;
}

double rounded_up(double number) {
    constexpr std::array kPreferred = {1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0, 10.0};
    const int exponent = static_cast<int>(std::floor(ieee::log10(number)));
    for (int power = exponent - 1; power <= exponent + 1; ++power) {
        const double unit = power < 0 ? 1.0 / ieee::pow(10.0, -power) : ieee::pow(10.0, power);
        for (const double preferred : kPreferred) {
            const double rounded =
                power < 0 ? preferred / ieee::pow(10.0, -power) : preferred * unit;
            if (rounded >= number) {
                return rounded;
            }
        }
    }
    return number;
}

}  // namespace foam::texgen
