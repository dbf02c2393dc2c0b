#include "texgen/raster/pixel_batch.h"

#include "texgen/raster/simd/vector_clones.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace foam::texgen {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
// Pixels that are so little past the end of an arc still face it, so that rounding leaves no gap
// where two arcs go on smoothly.
constexpr float kPastEnd = 1e-3F;
// Squares of distances below this, of pixels, count as this: their inverse has to be a float.
constexpr float kLeastSquare = 1e-12F;
// At an end of a film, where 0 over 0 would come up.
constexpr float kLeastRoot = 1e-18F;
// Sums below this have lost all films: that of a smooth distance of a million pixels.
constexpr float kLeastSum = 1e-12F;

// The first where all bits of the mask are set, the second where none is: without a branch, so
// that compilers take several at once.
std::uint32_t mask_if(bool condition) {
    return condition ? ~std::uint32_t{0} : 0;
}
float chosen(std::uint32_t mask, float first, float second) {
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(first) & mask) |
                                (std::bit_cast<std::uint32_t>(second) & ~mask));
}

struct SeenArc {
    // Of its distance, `over` / `under`; infinite where the pixel does not face the arc.
    float over;
    float under;
    float twice;  // the function across it, and its gradient
    float slope_x;
    float slope_y;
};

inline SeenArc seen_from(const FloatArc& arc, float x, float y) {
    const FloatQuadratic& f = arc.across;
    const float slope_x = f.x - f.curvature * x;
    const float slope_y = f.y - f.curvature * y;
    const float twice = f.twice_value + x * (f.x + slope_x) + y * (f.y + slope_y);
    const float length = std::sqrt(slope_x * slope_x + slope_y * slope_y);
    const float value = std::abs(twice);
    const float past_tail = arc.tail.value + x * arc.tail.x + y * arc.tail.y;
    const float before_head = arc.head.value + x * arc.head.x + y * arc.head.y;
    const float far = kFar;
    const float here = min_value(past_tail, before_head) >= -kPastEnd ? value : far;
    return {here, 1.0F + length, twice, slope_x, slope_y};
}

}  // namespace

void PixelBatch::clear(const Vec2& middle) {
    constexpr double kCenter = 0.5;
    middle_ = middle;
    first_x_ = static_cast<float>(middle.x() - kCenter);
    first_y_ = static_cast<float>(middle.y() - kCenter);
    count_ = 0;
    padded_ = 0;
    run_count_ = 0;
}

// To whole vectors.
void PixelBatch::pad() {
    padded_ = (count_ + kLanes - 1) / kLanes * kLanes;
    std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(count_), kLanes, x_[0]);
    std::fill_n(y_.begin() + static_cast<std::ptrdiff_t>(count_), kLanes, y_[0]);
}

FOAMTEX_VECTOR_CLONES void PixelBatch::add_arcs(std::span<const FloatArc> arcs) {
    pad();
    for (std::size_t from = 0; from < padded_; from += kLanes) {
        const float* x = &x_[from];
        const float* y = &y_[from];
        std::array<float, kLanes> over{};
        std::array<float, kLanes> under{};
        over.fill(kFar);
        under.fill(1.0F);
        for (const FloatArc& arc : arcs) {
            for (std::size_t k = 0; k < kLanes; ++k) {
                const SeenArc seen = seen_from(arc, x[k], y[k]);
                const std::uint32_t nearest = mask_if(seen.over * under[k] < over[k] * seen.under);
                over[k] = chosen(nearest, seen.over, over[k]);
                under[k] = chosen(nearest, seen.under, under[k]);
            }
        }
        std::memcpy(&over_[from], over.data(), sizeof over);
        std::memcpy(&under_[from], under.data(), sizeof under);
    }
}

FOAMTEX_VECTOR_CLONES void PixelBatch::add_arcs_and_gradients(std::span<const FloatArc> arcs) {
    pad();
    std::fill_n(over_.begin(), padded_, kFar);
    std::fill_n(under_.begin(), padded_, 1.0F);
    for (const FloatArc& some : arcs) {
        const FloatArc arc = some;
        for (std::size_t k = 0; k < padded_; ++k) {
            const SeenArc seen = seen_from(arc, x_[k], y_[k]);
            const float sign = std::copysign(1.0F, seen.twice);
            const std::uint32_t nearest = mask_if(seen.over * under_[k] < over_[k] * seen.under);
            gradient_x_[k] = chosen(nearest, sign * seen.slope_x, gradient_x_[k]);
            gradient_y_[k] = chosen(nearest, sign * seen.slope_y, gradient_y_[k]);
            over_[k] = chosen(nearest, seen.over, over_[k]);
            under_[k] = chosen(nearest, seen.under, under_[k]);
        }
    }
}

FOAMTEX_VECTOR_CLONES void PixelBatch::add_point(const Vec2& point) {
    const auto point_x = static_cast<float>(point.x());
    const auto point_y = static_cast<float>(point.y());
    for (std::size_t k = 0; k < padded_; ++k) {
        const float x = x_[k] - point_x;
        const float y = y_[k] - point_y;
        const float distance = std::sqrt(x * x + y * y);
        const std::uint32_t nearest = mask_if(distance * under_[k] < over_[k]);
        gradient_x_[k] = chosen(nearest, x, gradient_x_[k]);
        gradient_y_[k] = chosen(nearest, y, gradient_y_[k]);
        over_[k] = chosen(nearest, distance, over_[k]);
        under_[k] = chosen(nearest, 1.0F, under_[k]);
    }
}

FOAMTEX_VECTOR_CLONES bool PixelBatch::finish() {
    std::uint32_t any = 0;
    for (std::size_t k = 0; k < padded_; ++k) {
        any |= mask_if(over_[k] == kFar);
        distance_[k] = over_[k] / under_[k];
    }
    return any == 0;
}

FOAMTEX_VECTOR_CLONES void PixelBatch::normalize_gradients() {
    for (std::size_t k = 0; k < padded_; ++k) {
        const float x = gradient_x_[k];
        const float y = gradient_y_[k];
        const float length = std::sqrt(x * x + y * y);
        const float scale = length > 0.0F ? 1.0F / length : 0.0F;
        gradient_x_[k] = scale * x;
        gradient_y_[k] = scale * y;
    }
}

void PixelBatch::begin_smooth() {
    std::fill_n(smooth_.begin(), padded_, 0.0F);
    std::fill_n(smooth_x_.begin(), padded_, 0.0F);
    std::fill_n(smooth_y_.begin(), padded_, 0.0F);
}

// phi² = f² + r², r = (root - t) / 2, root = sqrt(t² + f^4 / c²), f being the function across the
// film, t the one along it, c its chord; r grad r = r (f³ / c² grad f - r grad t) / root.
FOAMTEX_VECTOR_CLONES void PixelBatch::add_film(const FloatQuadratic& across,
                                                const FloatQuadratic& along,
                                                float chord) {
    const FloatQuadratic a = across;
    const FloatQuadratic b = along;
    const float over_chord = 1.0F / chord;
    for (std::size_t k = 0; k < padded_; ++k) {
        const float x = x_[k];
        const float y = y_[k];
        const float fx = a.x - a.curvature * x;
        const float fy = a.y - a.curvature * y;
        const float tx = b.x - b.curvature * x;
        const float ty = b.y - b.curvature * y;
        const float f = 0.5F * (a.twice_value + x * (a.x + fx) + y * (a.y + fy));
        const float t = 0.5F * (b.twice_value + x * (b.x + tx) + y * (b.y + ty));
        const float bend = f * f * over_chord;
        const float root = max_value(std::sqrt(t * t + bend * bend), kLeastRoot);
        const float sum = root + std::abs(t);
        const float inside = 0.5F * bend * (bend / sum);
        const float r = t > 0.0F ? inside : 0.5F * sum;
        const float weight = 1.0F / max_value(f * f + r * r, kLeastSquare);
        const float part = r / root;  // at most 1
        const float from_f = f + part * (f * over_chord) * bend;
        const float from_t = -part * r;
        const float scale = weight * weight;
        smooth_[k] += weight;
        smooth_x_[k] += scale * (from_f * fx + from_t * tx);
        smooth_y_[k] += scale * (from_f * fy + from_t * ty);
    }
}

// s = S^-1/2, and grad s = s³ sum of phi^-4 (f grad f + r grad r).
FOAMTEX_VECTOR_CLONES void PixelBatch::finish_smooth() {
    for (std::size_t k = 0; k < padded_; ++k) {
        const float s = 1.0F / std::sqrt(smooth_[k]);
        const float scale = s * s * s;
        const std::uint32_t is_lost = mask_if(!(smooth_[k] > kLeastSum));
        smooth_[k] = chosen(is_lost, distance_[k], s);
        smooth_x_[k] = chosen(is_lost, gradient_x_[k], scale * smooth_x_[k]);
        smooth_y_[k] = chosen(is_lost, gradient_y_[k], scale * smooth_y_[k]);
    }
}

}  // namespace foam::texgen
