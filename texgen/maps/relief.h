// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/simd_level.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/grain.h"
#include "texgen/maps/maze.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/relief_section.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace foam::texgen {

/// The options of a relief. Borrows them.
struct ReliefSource {
    const ReliefOptions& relief;
    const MazeOptions& maze;  // used only if the walls of a maze shape the relief
};

/// The gradient of the height of a relief at the centers of pixels, in two images of one channel: x
/// to the right, y up.
struct PixelSlopes {
    Image<float> x;
    Image<float> y;
};

/// The relief of a frame: a surface whose height varies over the foam, at the centers of pixels.
/// Heights come from the smooth distance (DistanceField::smooth), which has no creases within a
/// bubble, and slopes come from its gradient. There are therefore creases only along films. A grain
/// (grain.h), which fades out toward films, is added if ReliefOptions::grain is above 0. With the
/// profiles Ridge and Wet, where bubbles are flat, the grain is never negative: it raises the
/// bubbles between the films. If only the walls of a maze shape the relief (ReliefFilms::Walls),
/// there is no grain, and the distance to the nearest wall replaces the smooth distance. There are
/// then also creases where two walls are equally near. Around a patch the relief is flat, except
/// for the outer half of ridges and wet films. Borrows the layers.
class Relief {
  public:
    /// In a relief of walls, distances above `reach` to the nearest wall count as infinite. `reach`
    /// is in units of the section (ReliefSection). It has no effect on reliefs of all films.
    Relief(FrameLayers& layers, const ReliefSource& source, double reach);
    /// The `reach` that suffices if only heights and slopes are used, because the relief is flat
    /// beyond the foot of ridges and of Plateau borders.
    static constexpr double kFoot = 1.0;

    Relief(const Relief&) = delete;
    Relief& operator=(const Relief&) = delete;

    /// Returns the heights at all pixels, in pixels.
    Image<float> heights() const;
    /// Returns the gradients of the height at all pixels. Precondition: FrameInput::distance of the
    /// layers selects the gradient of the smooth distance, or walls shape the relief.
    PixelSlopes slopes() const;

    /// Calls kernel(section, smooth, unit, index) for all pixels. `section` is the section of the
    /// profile (ReliefSection::visit), `smooth` is the smooth distance in units of the section, and
    /// `unit` is this unit in pixels. For domes, `smooth` and `unit` are 0 around a patch. The
    /// calls are made in a vectorized loop (at_simd_level). The kernel therefore has to be a
    /// function object that captures by value, and all functions that it calls have to be inline.
    template <class Kernel>
    void for_all_pixels(const Kernel& kernel) const;

    /// Return the smooth distance in pixels, and its gradient (DistanceField::smooth_gradient), at
    /// all pixels. In a relief of walls, return the distance to the nearest wall, which is infinite
    /// beyond the reach, and the gradient of this distance.
    const Image<float>& distance() const { return *smooth_; }
    const Image<float>& gradient() const { return *gradient_; }
    const ReliefSection& section() const { return section_; }
    /// Returns the unit of length of the section at a pixel, in pixels. For domes it is 0 around a
    /// patch. `index` counts pixels row by row from the bottom row.
    double unit(std::size_t index) const {
        return ids_ == nullptr ? width_ : radii_[ids_->samples()[index]];
    }
    bool has_grain() const { return grain_.has_value(); }
    /// Returns the factor on heights (ReliefOptions::strength).
    double strength() const { return strength_; }

    /// Returns the diameter of the mean bubble (ReliefOptions::mean_bubble) in pixels.
    double diameter() const { return diameter_; }

  private:
    void add_grain(const Grain& grain, Image<float>& heights) const;
    void add_grain(const Grain& grain, PixelSlopes& slopes) const;
    template <class Kernel>
    void visit_domes(const DomeSection& section, const Kernel& kernel) const;
    template <class Section, class Kernel>
    void visit_films(const Section& section, const Kernel& kernel) const;

    FrameLayers& layers_;
    ReliefSection section_;
    double strength_;
    double diameter_;
    double width_;  // the unit of the section in pixels, except for domes
    const Image<float>* smooth_ = nullptr;
    const Image<float>* gradient_ = nullptr;     // the gradient of `smooth_`
    const Image<std::uint32_t>* ids_ = nullptr;  // DistanceField::ids; only for domes
    std::vector<double> radii_;                  // units of domes, indexed by these ids
    std::optional<GrainRule> grain_;
    double grain_height_;  // factor on the values of the grain, pixels
};

template <class Kernel>
void Relief::visit_domes(const DomeSection& section, const Kernel& kernel) const {
    at_simd_level([=,
                   count = smooth_->samples().size(),
                   ids = ids_->samples().data(),
                   radii = radii_.data(),
                   pixels = smooth_->samples().data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const double unit = radii[ids[k]];
            const double smooth = unit > 0.0 ? static_cast<double>(pixels[k]) / unit : 0.0;
            kernel(section, smooth, unit, k);
        }
    });
}

template <class Section, class Kernel>
void Relief::visit_films(const Section& section, const Kernel& kernel) const {
    at_simd_level(
        [=, count = smooth_->samples().size(), unit = width_, pixels = smooth_->samples().data()] {
            for (std::size_t k = 0; k < count; ++k) {
                kernel(section, static_cast<double>(pixels[k]) / unit, unit, k);
            }
        });
}

template <class Kernel>
void Relief::for_all_pixels(const Kernel& kernel) const {
    section_.visit([&](const auto& section) {
        if constexpr (std::is_same_v<std::decay_t<decltype(section)>, DomeSection>) {
            if (ids_ != nullptr) {
                return visit_domes(section, kernel);
            }
        }
        visit_films(section, kernel);
    });
}

}  // namespace foam::texgen
