// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_fit.h"

#include "texgen/blocks/bc7_modes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

// The first endpoints are the ends of the principal axis of the colors. Every texel gets the index
// of the nearest color between the endpoints. For these indices, the endpoints are then improved by
// least squares, as in S. Brown's "DXT compression techniques" (2006). Both endpoints are rounded
// together: of the codes below and above each of them, the pair with the smallest error is used.

namespace foam::texgen::bc7 {

namespace {

constexpr int kRefinements = 2;  // least squares steps

// A squared error as a function of both ends of a line, apart from a constant. For the ends x and y
// of channel c, it is
//     first x^2 + 2 mixed x y + second y^2 - 2 sums[0][c] x - 2 sums[1][c] y.
struct SquaredError {
    float first = 1.0F;
    float mixed = 0.0F;
    float second = 1.0F;
    Line sums{};

    float at(std::size_t channel, float x, float y) const {
        return x * (first * x + 2.0F * (mixed * y - sums[0][channel])) +
               y * (second * y - 2.0F * sums[1][channel]);
    }
};

using LowestBits = std::array<int, 2>;

// Mode 6: 7 bits per channel and a lowest bit per endpoint.
struct Mode6 {
    static constexpr std::span<const int> kWeights = kWeights4;
    static constexpr std::size_t kChannels = 4;
    static constexpr int kLargestCode = 127;

    static int color(int code, int lowest) { return code * 2 + lowest; }
    // Returns the code, before it is rounded, of a color.
    static float code(float color, int lowest) {
        return (color - static_cast<float>(lowest)) * 0.5F;
    }
    // Returns the lowest bits to try. With 1 and 1, the alpha of an opaque block stays 255.
    static std::span<const LowestBits> lowest_bits(bool opaque) {
        static constexpr std::array<LowestBits, 4> kAll = {{{1, 1}, {0, 0}, {0, 1}, {1, 0}}};
        return std::span(kAll).first(opaque ? 1 : kAll.size());
    }
};

// Mode 1: 6 bits per color channel and a lowest bit that both endpoints of a subset share.
struct Mode1 {
    static constexpr std::span<const int> kWeights = kWeights3;
    static constexpr std::size_t kChannels = 3;
    static constexpr int kLargestCode = 63;

    static int color(int code, int lowest) { return expanded7(code * 2 + lowest); }
    static float code(float color, int lowest) {
        constexpr float kTo7Bits = 127.0F / 255.0F;
        return (color * kTo7Bits - static_cast<float>(lowest)) * 0.5F;
    }
    static std::span<const LowestBits> lowest_bits(bool /*opaque*/) {
        static constexpr std::array<LowestBits, 2> kShared = {{{0, 0}, {1, 1}}};
        return kShared;
    }
};

// Rounds one channel of both ends of a line. Of the codes below and above each end, the pair with
// the smallest error is stored in `ends`. Returns this error.
template <class Mode>
float round_channel(std::size_t channel,
                    const Line& line,
                    const SquaredError& error,
                    Endpoints& ends) {
    std::array<int, 2> below{};
    for (std::size_t e = 0; e < 2; ++e) {
        const float code = Mode::code(line[e][channel], ends.lowest[e]);
        below[e] = std::clamp(static_cast<int>(std::floor(code)), 0, Mode::kLargestCode - 1);
    }
    float smallest = std::numeric_limits<float>::infinity();
    for (int k = 0; k < 4; ++k) {
        const std::array<int, 2> codes = {below[0] + (k & 1), below[1] + (k >> 1)};
        const std::array<int, 2> colors = {Mode::color(codes[0], ends.lowest[0]),
                                           Mode::color(codes[1], ends.lowest[1])};
        const float found =
            error.at(channel, static_cast<float>(colors[0]), static_cast<float>(colors[1]));
        if (found < smallest) {
            smallest = found;
            for (std::size_t e = 0; e < 2; ++e) {
                ends.codes[e][channel] = codes[e];
                ends.colors[e][channel] = colors[e];
            }
        }
    }
    return smallest;
}

// Rounds both ends of a line to endpoints of a mode.
template <class Mode>
Endpoints quantized(const Line& line, const SquaredError& error, bool opaque) {
    Endpoints best;
    float smallest = std::numeric_limits<float>::infinity();
    for (const LowestBits& lowest : Mode::lowest_bits(opaque)) {
        Endpoints ends;
        ends.lowest = lowest;
        ends.colors[0][3] = 255;
        ends.colors[1][3] = 255;
        float sum = 0.0F;
        for (std::size_t channel = 0; channel < Mode::kChannels; ++channel) {
            sum += round_channel<Mode>(channel, line, error, ends);
        }
        if (sum < smallest) {
            smallest = sum;
            best = ends;
        }
    }
    return best;
}

// Chooses the index of the nearest color for every texel of a subset. The weights are nearly evenly
// spaced, so the index follows from the position along the line.
Fit with_indices(const Colors& colors,
                 Subset subset,
                 const Endpoints& ends,
                 std::span<const int> weights) {
    Fit fit{.ends = ends, .error = 0.0F};
    Color along{};
    float square = 0.0F;
    for (std::size_t c = 0; c < 4; ++c) {
        along[c] = static_cast<float>(ends.colors[1][c] - ends.colors[0][c]);
        square += along[c] * along[c];
    }
    const auto last = static_cast<int>(weights.size()) - 1;
    const float scale = square > 0.0F ? static_cast<float>(last) / square : 0.0F;
    for (int k = 0; k < kBlockTexels; ++k) {
        if (!has_texel(subset, k)) {
            continue;
        }
        const Color& color = colors.texels[static_cast<std::size_t>(k)];
        float position = 0.5F;
        for (std::size_t c = 0; c < 4; ++c) {
            position += (color[c] - static_cast<float>(ends.colors[0][c])) * along[c] * scale;
        }
        const int index = std::clamp(static_cast<int>(position), 0, last);
        fit.indices[static_cast<std::size_t>(k)] = index;
        for (std::size_t c = 0; c < 4; ++c) {
            const int shown = interpolated(
                ends.colors[0][c], ends.colors[1][c], weights[static_cast<std::size_t>(index)]);
            const float difference = static_cast<float>(shown) - color[c];
            fit.error += difference * difference;
        }
    }
    return fit;
}

// Returns the squared error of the colors of a subset for fixed indices.
SquaredError error_for_indices(const Colors& colors,
                               Subset subset,
                               const Fit& fit,
                               std::span<const int> weights) {
    SquaredError error{0.0F, 0.0F, 0.0F, {}};
    for (unsigned rest = subset; rest != 0; rest &= rest - 1) {
        const auto texel = static_cast<std::size_t>(std::countr_zero(rest));
        const float weight =
            static_cast<float>(weights[static_cast<std::size_t>(fit.indices[texel])]) / 64.0F;
        error.first += (1.0F - weight) * (1.0F - weight);
        error.mixed += weight * (1.0F - weight);
        error.second += weight * weight;
        for (std::size_t c = 0; c < 4; ++c) {
            error.sums[0][c] += (1.0F - weight) * colors.texels[texel][c];
            error.sums[1][c] += weight * colors.texels[texel][c];
        }
    }
    return error;
}

// Returns the line with the smallest squared error, or nullopt if the error does not determine it.
std::optional<Line> best_line(const SquaredError& error) {
    const float determinant = error.first * error.second - error.mixed * error.mixed;
    if (determinant < 1e-3F) {
        return std::nullopt;
    }
    Line line{};
    for (std::size_t c = 0; c < 4; ++c) {
        const float low = error.second * error.sums[0][c] - error.mixed * error.sums[1][c];
        const float high = error.first * error.sums[1][c] - error.mixed * error.sums[0][c];
        line[0][c] = std::clamp(low / determinant, 0.0F, 255.0F);
        line[1][c] = std::clamp(high / determinant, 0.0F, 255.0F);
    }
    return line;
}

// Approximates the colors of a subset. The first endpoints are the ends of the principal axis.
template <class Mode>
Fit fit_subset(const Colors& colors, Subset subset) {
    const Line line = principal_line(colors, subset);
    Fit best = with_indices(colors,
                            subset,
                            quantized<Mode>(line, {1.0F, 0.0F, 1.0F, line}, colors.opaque),
                            Mode::kWeights);
    for (int k = 0; k < kRefinements; ++k) {
        const SquaredError error = error_for_indices(colors, subset, best, Mode::kWeights);
        const std::optional<Line> improved = best_line(error);
        if (!improved) {
            break;
        }
        const Endpoints ends = quantized<Mode>(*improved, error, colors.opaque);
        Fit fit = with_indices(colors, subset, ends, Mode::kWeights);
        if (fit.error >= best.error) {
            break;
        }
        best = fit;
    }
    return best;
}

}  // namespace

Fit fit_mode1(const Colors& colors, Subset subset) {
    return fit_subset<Mode1>(colors, subset);
}

Fit fit_mode6(const Colors& colors, Subset subset) {
    return fit_subset<Mode6>(colors, subset);
}

}  // namespace foam::texgen::bc7
