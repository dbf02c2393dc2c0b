// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<ReliefOptions> relief_keys() {
    using Options = ReliefOptions;
    constexpr Choices<ReliefProfile, 3> kProfiles = {{{{"dome", ReliefProfile::Dome},
                                                       {"ridge", ReliefProfile::Ridge},
                                                       {"wet", ReliefProfile::Wet}}}};
    constexpr Choices<ReliefFilms> kFilms = {
        {{{"all", ReliefFilms::All}, {"walls", ReliefFilms::Walls}}}};
    return {
        key("profile",
            kProfiles,
            "shape of the surface that the maps height, normal, occlusion, curvature, lit and "
            "caustics show: domes, rounded ridges on films, or wet films with Plateau borders",
            &Options::profile),
        key("films",
            kFilms,
            "films that the relief shows as ridges or wet films: all of them, or only the walls of "
            "the maze (table maze)",
            &Options::films)
            .only_for("relief.profile", {"ridge", "wet"}),
        key("angle", Reals{1.0, 85.0}, "slope of domes at films, degrees", &Options::angle)
            .in("degrees")
            .used_with("relief.profile", {"dome"}),
        key("width",
            Reals{0.001, 10.0},
            "distance from a film to the foot of its ridge, or radius of Plateau borders, in "
            "bubble diameters",
            &Options::width)
            .in(kReliefDiameters)
            .used_with("relief.profile", {"ridge", "wet"}),
        key("strength", Reals{0.0, 100.0}, "factor on all heights", &Options::strength),
        key("grain",
            Reals{0.0, 10.0},
            "height of a fine grain that moves with each bubble, in bubble diameters, before it "
            "is scaled by relief.strength; 0 disables the grain",
            &Options::grain)
            .in(kReliefDiameters)
            .only_for("relief.films", {"all"}),
        key("grain_size",
            Reals{0.01, 10.0},
            "size of the largest features of the grain, in diameters of a mean bubble of the "
            "seeded foam",
            &Options::grain_size)
            .in("mean bubble diameters of the seeded foam")
            .only_for("relief.films", {"all"})
            .unused_with("relief.grain", {"0.0"}),
        key("mean_bubble",
            kMeanBubbles,
            "the unit of heights and widths is the diameter of a mean bubble: of the seeded foam "
            "(seed) or of the drawn frame (current)",
            &Options::mean_bubble)};
}

}  // namespace foam::texgen
