// SPDX-License-Identifier: Apache-2.0

// Compares our rasterizer with other libraries and prints Markdown tables. The contenders take
// turns; each time is the shortest of several runs. Times are processor times on one thread, except
// for the comparison of one and two threads, which measures elapsed time. Libraries that were not
// found when CMake was configured are left out.
#include "tests/bench/bench_foams.h"
#include "tests/bench/raster_peers/peers.h"
#include "tests/bench/raster_peers/race.h"
#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"
#include "texgen/raster/distance/distance.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace foam::bench {

namespace {

using texgen::CellArcs;
using texgen::DistanceField;
using texgen::Image;

constexpr int kSide = 2048;
constexpr int kLargeSide = 4096;
constexpr int kRounds = 5;
constexpr int kWallRounds = 30;  // more rounds, because other programs disturb elapsed times

// Our own rasterizer. It draws a frame into an RGB image of 16 bits per channel, as the maps do.
// The memory of the image is reused between runs. The images of the other libraries have 8 bits.
class Foamtex {
  public:
    Foamtex(const Frame& frame, const Scene& scene)
        : frame_(frame),
          grid_{scene.side, scene.side},
          values_(values_of(scene)),
          image_(scene.side, scene.side, 3) {}

    void fill(double film_width, int threads) {
        const CellArcs cells = texgen::cell_arcs(frame_, grid_, film_width, threads);
        texgen::fill_cells(cells, values_, threads, image_.view());
    }
    void measure(int threads) { texgen::write_distance_field(frame_, grid_, {}, threads, field_); }
    const Image<std::uint16_t>& image() const { return image_; }
    const DistanceField& field() const { return field_; }

  private:
    const Frame& frame_;
    texgen::RasterGrid grid_;
    texgen::CellValues values_;
    Image<std::uint16_t> image_;
    DistanceField field_;
};

void print_row(const std::string& work,
               const Contender& ours,
               const Contender& other,
               double target) {
    fmt::print("| {} | {:.1f} ms | {}: {:.1f} ms | {:.2f} | {} |\n",
               work,
               1e3 * ours.seconds,
               other.name,
               1e3 * other.seconds,
               other.seconds / ours.seconds,
               target > 0.0 ? fmt::format("≥ {}", target) : "");
}

// Races the contenders and prints one row for each contender after the first one, which is compared
// with it. `targets` are the target ratios of these rows; 0 means no target.
void print_race(const std::string& work,
                std::vector<Contender> contenders,
                const std::vector<double>& targets) {
    race(contenders, kRounds, Clock::Processor);
    for (std::size_t k = 1; k < contenders.size(); ++k) {
        print_row(work, contenders[0], contenders[k], k <= targets.size() ? targets[k - 1] : 0.0);
    }
}

std::string name_of(const std::string& work, int side, int bubbles) {
    return fmt::format("{}, {}², {} bubbles", work, side, bubbles);
}

void compare_fills(int side, int bubbles) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    const Scene scene = scene_of(frame, side);
    Foamtex ours(frame, scene);
    std::vector<Contender> contenders{{"foamtex", [&] { ours.fill(0.0, 1); }}};
    const std::vector<Painter> others = painters(side);
    for (const Painter& other : others) {
        contenders.push_back({other.name, [&] { other.fill(scene); }});
    }
    print_race(name_of("16-bit fill", side, bubbles), contenders, {12.0, 0.0, 4.5});
}

void compare_strokes(int side, int bubbles, bool with_distance) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    const Scene scene = scene_of(frame, side);
    Foamtex ours(frame, scene);
    const auto draw = [&] {
        ours.fill(kFilmWidth, 1);
        if (with_distance) {
            ours.measure(1);
        }
    };
    std::vector<Contender> contenders{{"foamtex", draw}};
    const std::vector<Painter> others = painters(side);
    for (const Painter& other : others) {
        if (other.fill_and_films) {
            contenders.push_back({other.name, [&] { other.fill_and_films(scene); }});
        }
    }
    const std::string work =
        with_distance ? "16-bit fill + films + ids + distance" : "16-bit fill + films";
    print_race(name_of(work, side, bubbles), contenders, {with_distance ? 6.5 : 12.0});
}

// Returns a mask for the peers, which measure the distance to pixels of value 0. A pixel is 0 if
// the next pixel in x or in y belongs to another bubble, otherwise 255.
Image<std::uint8_t> films_of(const DistanceField& field) {
    const int side = field.ids.width();
    Image<std::uint8_t> mask(side, side, 1);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::uint32_t id = field.ids.pixel(x, y)[0];
            const bool inside = id == field.ids.pixel((x + 1) % side, y)[0] &&
                                id == field.ids.pixel(x, (y + 1) % side)[0];
            mask.pixel(x, y)[0] = inside ? 255 : 0;
        }
    }
    return mask;
}

void compare_distances(const Frame& frame, int side, double target) {
    const Scene scene = scene_of(frame, side);
    Foamtex ours(frame, scene);
    ours.measure(1);
    const Image<std::uint8_t> mask = films_of(ours.field());
    std::vector<Contender> contenders{{"foamtex", [&] { ours.measure(1); }}};
    const std::vector<DistanceTransform> others = distance_transforms(side);
    for (const DistanceTransform& other : others) {
        contenders.push_back({other.name, [&] { other.transform(mask); }});
    }
    print_race(name_of("ids + distance", side, static_cast<int>(frame.bubbles.size())),
               contenders,
               {target});
}

void compare_threads(int side, int bubbles) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    Foamtex ours(frame, scene_of(frame, side));
    struct Work {
        std::string name;
        std::function<void(int)> run;  // the argument is the number of threads
    };
    const std::vector<Work> works{
        {"16-bit fill", [&](int threads) { ours.fill(0.0, threads); }},
        {"16-bit fill + films", [&](int threads) { ours.fill(kFilmWidth, threads); }},
        {"ids + distance", [&](int threads) { ours.measure(threads); }}};
    std::vector<Contender> contenders;
    for (const Work& work : works) {
        contenders.push_back({"two threads", [&work] { work.run(2); }});
        contenders.push_back({"one thread", [&work] { work.run(1); }});
    }
    // All contenders are in one race, which lasts longer than a disturbance by another program.
    race(contenders, kWallRounds, Clock::Wall);
    for (std::size_t k = 0; k < works.size(); ++k) {
        print_row(name_of(works[k].name + " on two threads", side, bubbles),
                  contenders[2 * k],
                  contenders[2 * k + 1],
                  1.8);
    }
}

void compare_with_writing(int side, int bubbles) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    Foamtex ours(frame, scene_of(frame, side));
    Image<std::uint16_t> image(side, side, 3);
    std::uint16_t level = 0;
    const auto write_one_value = [&] { std::ranges::fill(image.samples(), ++level); };
    // Pixels that differ cannot be filled with one value. They must at least be copied.
    std::vector<std::uint16_t> row(image.row(0).size());
    const auto write_rows = [&] {
        for (int y = 0; y < side; ++y) {
            row[static_cast<std::size_t>(y)] = ++level;
            std::ranges::copy(row, image.row(y).begin());
        }
    };
    print_race(name_of("16-bit fill", side, bubbles),
               {{"foamtex", [&] { ours.fill(0.0, 1); }},
                {"writing one value alone", write_one_value},
                {"copying rows alone", write_rows}},
               {});
}

// Returns the exact value of each channel of each pixel, computed from point samples: the mean of
// the colors of the bubbles and of white films, weighted by area.
std::vector<double> reference(const Frame& frame,
                              const Scene& scene,
                              double film_width,
                              test::Samples samples) {
    const test::SampledCoverage sampled =
        test::sample_coverage(frame, scene.side, scene.side, film_width, samples);
    std::vector<double> means;
    for (const std::vector<double>& parts : sampled.parts) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double mean = 255.0;
            for (std::size_t k = 0; k < parts.size(); ++k) {
                mean += parts[k] * (scene.colors[k][channel] - 255.0);
            }
            means.push_back(mean);
        }
    }
    return means;
}

// Returns the largest error of a sample, in units of 1/255 of the range of values.
template <class Sample>
double largest_error(const Image<Sample>& image, const std::vector<double>& means) {
    constexpr double kUnit = std::numeric_limits<Sample>::max() / 255.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < means.size(); ++k) {
        largest = std::max(largest, std::abs(image.samples()[k] / kUnit - means[k]));
    }
    return largest;
}

// The reference images of one film width, one for each set of sample positions.
struct References {
    std::vector<double> lattice;
    std::vector<double> grid;

    References(const Frame& frame, const Scene& scene, double film_width)
        : lattice(reference(frame, scene, film_width, test::Samples::Lattice)),
          grid(reference(frame, scene, film_width, test::Samples::Grid)) {}

    template <class Sample>
    void print(const Image<Sample>& image) const {
        fmt::print(" {:.2f} | {:.2f} |", largest_error(image, lattice), largest_error(image, grid));
    }
};

void print_errors() {
    constexpr int kSmallSide = 64;
    const Frame frame = test::fitted_frame(test::polydisperse_foam(24, 5), kSmallSide, kSmallSide);
    const Scene scene = scene_of(frame, kSmallSide);
    Foamtex ours(frame, scene);
    const References cells(frame, scene, 0.0);
    const References films(frame, scene, kFilmWidth);
    fmt::print(
        "\n| largest error of a pixel, of 255 | fill | against 64 x 64 samples | fill + films | "
        "against 64 x 64 samples |\n"
        "|---|---|---|---|---|\n| foamtex |");
    ours.fill(0.0, 1);
    cells.print(ours.image());
    ours.fill(kFilmWidth, 1);
    films.print(ours.image());
    for (const Painter& other : painters(kSmallSide)) {
        fmt::print("\n| {} |", other.name);
        other.fill(scene);
        cells.print(other.image());
        if (other.fill_and_films) {
            other.fill_and_films(scene);
            films.print(other.image());
        } else {
            fmt::print(" | |");
        }
    }
    fmt::print("\n");
}

void run() {
    fmt::print("| work | foamtex | compared with | ratio | target |\n|---|---|---|---|---|\n");
    compare_fills(kSide, 10000);
    compare_strokes(kSide, 10000, true);
    compare_strokes(kSide, 1000, false);
    compare_strokes(kLargeSide, 1000, false);
    compare_distances(snapshot(equilibrated_foam(10000), 1), kSide, 3.5);
    compare_distances(snapshot(test::bent_foam(100000, 0.3, 1), 1), kSide, 1.0);
    compare_threads(kSide, 10000);
    compare_with_writing(kLargeSide, 1000);
    print_errors();
}

}  // namespace

}  // namespace foam::bench

int main() {
    foam::bench::run();
}
