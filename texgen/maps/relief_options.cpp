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
            "shape of the surface of height, normal, occlusion, curvature and lit: domes, rounded "
            "ridges on films, or wet films with Plateau borders",
            &Options::profile),
        key("films",
            kFilms,
            "films from which ridges and wet films rise: all of them, or only the walls of the "
            "maze (table maze)",
            &Options::films)
            .only_for("relief.profile", {"ridge", "wet"}),
        key("angle", Reals{1.0, 85.0}, "slope of domes at films, degrees", &Options::angle)
            .in("degrees"),
        key("width",
            Reals{0.001, 10.0},
            "width of a ridge from film to foot, or radius of Plateau borders, in bubble diameters",
            &Options::width)
            .in(kReliefDiameters),
        key("strength", Reals{0.0, 100.0}, "factor that scales all heights", &Options::strength),
        key("mean_bubble",
            kMeanBubbles,
            "mean bubble whose diameter is the unit: of the seeded foam or of this frame",
            &Options::mean_bubble)};
}

}  // namespace foam::texgen
