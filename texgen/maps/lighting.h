// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/reflections.h"
#include "texgen/maps/relief_points.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// A distant light, and how the surface reflects it. The viewer is straight above the foam.
struct LightOptions {
    double azimuth = 135.0;   // direction to the light, degrees counterclockwise from the right
    double elevation = 50.0;  // angle of the light above the plane of the foam, degrees
    double ambient = 0.4;     // fraction of the diffuse light that comes from a uniform sky
    double gloss = 0.25;      // brightness of highlights
    double shininess = 40.0;  // exponent of highlights; larger values make them smaller
    double rim = 0.0;         // brightness added to steep slopes, such as the rims of bubbles
    ReflectionOptions reflections{};
};

Keys<LightOptions> light_keys();

/// The light at points of a relief. It shows a surface of the color c in the color
/// `diffuse` * c + `shine`. The spans have one number per point.
struct PointLights {
    std::span<float> diffuse;
    std::span<float> shine;
};

/// A table of the brightness of a highlight. The table is indexed by the cosine of the angle
/// between the normal and the halfway vector. The brightness is cosine^shininess, minus its value
/// on flat ground, but at least 0.
struct HighlightTable {
    /// `flat` is the cosine on flat ground. The brightness is multiplied by `gloss`.
    HighlightTable(double gloss, double shininess, double flat);

    /// The brightness at equally spaced cosines from `first` to 1. At smaller cosines it is 0.
    std::vector<double> brightness;
    double first;
};

/// Computes the light at points of a relief. Flat ground from which the whole sky is visible has
/// the diffuse light 1 and no shine.
class Lighting {
  public:
    explicit Lighting(const LightOptions& options);

    /// Writes the light at `points` to `lights`.
    void shade(const ReliefPoints<const float>& points, const PointLights& lights) const;

  private:
    template <bool Reflects>
    void shade_points(const ReliefPoints<const float>& points, const PointLights& lights) const;

    double ambient_;
    double rim_;
    Direction light_;    // the direction to the light
    Direction halfway_;  // halfway between the directions to the light and to the viewer
    HighlightTable highlights_;
    Reflections reflections_;
};

}  // namespace foam::texgen
