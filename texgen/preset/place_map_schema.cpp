#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"
#include "texgen/preset/map_choices.h"
#include "texgen/preset/map_schema.h"

namespace foam::texgen {

namespace {

constexpr Choices<MotionUnit> kMotionUnits = {
    {{{"image", MotionUnit::Image}, {"px", MotionUnit::Pixels}}}};
constexpr Choices<MotionY> kMotionY = {{{{"up", MotionY::Up}, {"down", MotionY::Down}}}};
constexpr Choices<DistanceKind> kDistanceKinds = {
    {{{"plain", DistanceKind::Plain}, {"signed", DistanceKind::Signed}}}};
constexpr Choices<DistanceUnit> kDistanceUnits = {
    {{{"foam", DistanceUnit::Foam}, {"px", DistanceUnit::Pixels}}}};
constexpr Choices<ReliefProfile, 3> kReliefProfiles = {{{{"dome", ReliefProfile::Dome},
                                                         {"ridge", ReliefProfile::Ridge},
                                                         {"wet", ReliefProfile::Wet}}}};
constexpr Choices<NormalY> kNormalY = {{{{"gl", NormalY::Up}, {"dx", NormalY::Down}}}};

std::vector<Key> motion_keys() {
    using Options = MotionOptions;
    const auto one = keys_in(&MapOptions::motion);
    return {one("motion.unit",
                kMotionUnits,
                "of floats: parts of the image's width, or pixels; a PNG is the same for both",
                &Options::unit),
            one("motion.y", kMotionY, "where a positive second number points", &Options::y),
            one("motion.multiplier",
                Reals{1e-6, 10.0},
                "of a PNG: motion at its largest code, in parts of the image's width; 0 is its "
                "negative",
                &Options::multiplier)};
}

std::vector<Key> distance_keys() {
    using Options = DistanceOptions;
    const auto one = keys_in(&MapOptions::distance);
    return {one("distance.kind",
                kDistanceKinds,
                "from the middle of films, or from their edges: negative in films and around a "
                "patch",
                &Options::kind),
            one("distance.unit", kDistanceUnits, "foam units or pixels", &Options::unit),
            one("distance.full",
                Reals{1e-6, 1e6},
                "distance that a PNG has as its largest code, in the unit",
                &Options::full)};
}

// Of height, normal, occlusion and curvature together.
std::vector<Key> relief_keys() {
    using Options = ReliefOptions;
    const auto one = keys_in(&MapOptions::relief);
    return {one("relief.profile",
                kReliefProfiles,
                "of height, normal, occlusion, curvature: domes, rounded ridges on films, or wet "
                "films with the fillets of Plateau borders",
                &Options::profile),
            one("relief.angle", Reals{1.0, 85.0}, "of domes at films, degrees", &Options::angle),
            one("relief.width",
                Reals{0.001, 10.0},
                "from a film to the foot of its ridge, or the radius of borders, in bubble "
                "diameters",
                &Options::width),
            one("relief.strength", Reals{0.0, 100.0}, "factor on heights", &Options::strength),
            one("relief.mean_bubble",
                kMeanBubbles,
                "whose diameter that is: of the seeded foam or of this frame",
                &Options::mean_bubble),
            key("height.full",
                Reals{1e-6, 1e6},
                "height that a PNG has as its largest code, in bubble diameters",
                &Preset::maps,
                &MapOptions::height,
                &HeightOptions::full),
            key("normal.y",
                kNormalY,
                "the way that green points: gl is up (Blender, Godot, Unity), dx down (Unreal)",
                &Preset::maps,
                &MapOptions::normal,
                &NormalOptions::y),
            key("occlusion.strength",
                Reals{0.0, 100.0},
                "power of the part of the sky that is seen",
                &Preset::maps,
                &MapOptions::occlusion,
                &OcclusionOptions::strength),
            key("curvature.radius",
                Reals{0.001, 10.0},
                "over which it is felt, in bubble diameters",
                &Preset::maps,
                &MapOptions::curvature,
                &CurvatureOptions::radius),
            key("curvature.full",
                Reals{1e-6, 1e6},
                "that a PNG has as its largest code; its negative is 0",
                &Preset::maps,
                &MapOptions::curvature,
                &CurvatureOptions::full)};
}

std::vector<Key> thin_film_keys() {
    using Options = ThinFilmOptions;
    const auto one = keys_in(&MapOptions::thin_film);
    return {one("thin_film.thickness",
                Reals{0.0, 3000.0},
                "of soap films in the middle of bubbles, nanometres",
                &Options::thickness),
            one("thin_film.variation",
                Reals{0.0, 2.0},
                "by so much of it bubbles differ at most",
                &Options::variation),
            one("thin_film.drainage",
                Reals{0.0, 10.0},
                "by so much of it a film is thicker at the rim of its bubble",
                &Options::drainage),
            one("thin_film.exposure",
                Reals{0.0, 100.0},
                "factor on the light, of which a soap film reflects 8 % at most",
                &Options::exposure)};
}

}  // namespace

std::vector<Key> place_map_keys() {
    std::vector<Key> all;
    for (const auto& keys : {motion_keys(), distance_keys(), relief_keys(), thin_film_keys()}) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

}  // namespace foam::texgen
