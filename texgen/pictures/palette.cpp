// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/palette.h"

#include "texgen/image/oklab.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

// Pixels are first collected in bins, which are cubes of the sRGB color space. There are 32 bins
// per channel, and at most 32768 in all. The algorithm k-means then clusters the bins instead of
// the pixels. Each bin has the total weight and the mean color of its pixels.

namespace foam::texgen {

namespace {

// A picture with more pixels is thinned out: only every second, third, ... pixel of each row and of
// each column counts.
constexpr double kMaxPixels = 1'000'000.0;
constexpr int kBitsOfBin = 5;  // a channel has 2^kBitsOfBin bins
constexpr int kMaxRounds = 300;
constexpr double kConverged = 1e-6;  // k-means ends if no center moves by more, in Oklab

struct Bin {
    Oklab color;  // the mean color
    double weight = 0.0;
};

double squared_distance(const Oklab& a, const Oklab& b) {
    const double lightness = a.lightness - b.lightness;
    const double along_a = a.a - b.a;
    const double along_b = a.b - b.b;
    return lightness * lightness + along_a * along_a + along_b * along_b;
}

// The sum of weighted colors.
class ColorSum {
  public:
    void add(const Oklab& color, double weight) {
        lightness_ += weight * color.lightness;
        a_ += weight * color.a;
        b_ += weight * color.b;
        weight_ += weight;
    }
    double weight() const { return weight_; }
    Oklab mean() const { return {lightness_ / weight_, a_ / weight_, b_ / weight_}; }

  private:
    double lightness_ = 0.0;
    double a_ = 0.0;
    double b_ = 0.0;
    double weight_ = 0.0;
};

// Returns the bin of the color of a pixel. `codes` is the table srgb_codes_of_light().
std::size_t bin_of(std::span<const std::uint16_t> pixel, std::span<const std::uint8_t> codes) {
    std::size_t bin = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        bin = (bin << kBitsOfBin) | (codes[pixel[k]] >> (8 - kBitsOfBin));
    }
    return bin;
}

std::vector<Bin> bins_of(const SourcePicture& picture) {
    const double pixels = static_cast<double>(picture.width()) * picture.height();
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels))));
    const std::span<const std::uint8_t> codes = srgb_codes_of_light();
    std::vector<ColorSum> sums(std::size_t{1} << (3 * kBitsOfBin));
    for (int y = step / 2; y < picture.height(); y += step) {
        for (int x = step / 2; x < picture.width(); x += step) {
            const SourcePixel pixel = pixel_of(picture, x, y);
            if (pixel.opacity > 0.0) {
                sums[bin_of(picture.pixels.pixel(x, y), codes)].add(to_oklab(pixel.color),
                                                                    pixel.opacity);
            }
        }
    }
    std::vector<Bin> bins;
    for (const ColorSum& sum : sums) {
        if (sum.weight() > 0.0) {
            bins.push_back({sum.mean(), sum.weight()});
        }
    }
    return bins;
}

// Returns the index of the center that is nearest to a color, and the squared distance.
std::pair<std::size_t, double> nearest_center(const std::vector<Oklab>& centers,
                                              const Oklab& color) {
    std::pair<std::size_t, double> best{0, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < centers.size(); ++k) {
        const double distance = squared_distance(centers[k], color);
        best = distance < best.second ? std::pair(k, distance) : best;
    }
    return best;
}

// Returns the centers from which k-means starts. The first one is the most frequent color. Each of
// the next ones is the color with the largest product of its weight and its squared distance from
// the nearest earlier center. Rare outliers therefore do not become centers. The algorithm
// k-means++ instead draws centers at random, with probabilities in proportion to this product (D.
// Arthur, S. Vassilvitskii, 2007).
std::vector<Oklab> first_centers(const std::vector<Bin>& bins, int count) {
    const auto most_frequent = std::ranges::max_element(bins, {}, &Bin::weight);
    std::vector<Oklab> centers{most_frequent->color};
    std::vector<double> distances(bins.size(), std::numeric_limits<double>::infinity());
    while (centers.size() < static_cast<std::size_t>(count)) {
        std::size_t best = 0;
        double largest = 0.0;
        for (std::size_t k = 0; k < bins.size(); ++k) {
            distances[k] = std::min(distances[k], squared_distance(bins[k].color, centers.back()));
            if (bins[k].weight * distances[k] > largest) {
                largest = bins[k].weight * distances[k];
                best = k;
            }
        }
        if (largest == 0.0) {
            break;  // every color is a center
        }
        centers.push_back(bins[best].color);
    }
    return centers;
}

// Moves each center to the mean of the colors that are nearest to it. Returns the largest shift of
// a center. A center without colors is not moved.
double move_centers(const std::vector<Bin>& bins, std::vector<Oklab>& centers) {
    std::vector<ColorSum> sums(centers.size());
    for (const Bin& bin : bins) {
        sums[nearest_center(centers, bin.color).first].add(bin.color, bin.weight);
    }
    double shift = 0.0;
    for (std::size_t k = 0; k < centers.size(); ++k) {
        if (sums[k].weight() > 0.0) {
            const Oklab mean = sums[k].mean();
            shift = std::max(shift, std::sqrt(squared_distance(mean, centers[k])));
            centers[k] = mean;
        }
    }
    return shift;
}

}  // namespace

std::vector<Srgb8> palette_of(const SourcePicture& picture, int count) {
    const std::vector<Bin> bins = bins_of(picture);
    if (bins.empty()) {
        return {};
    }
    std::vector<Oklab> centers = first_centers(bins, count);
    for (int round = 0; round < kMaxRounds && move_centers(bins, centers) > kConverged; ++round) {
    }
    std::ranges::sort(centers, [](const Oklab& a, const Oklab& b) {
        return std::tie(a.lightness, a.a, a.b) < std::tie(b.lightness, b.a, b.b);
    });
    std::vector<Srgb8> colors;
    colors.reserve(centers.size());
    for (const Oklab& center : centers) {
        colors.push_back(to_srgb8(to_linear(center)));
    }
    return colors;
}

}  // namespace foam::texgen
