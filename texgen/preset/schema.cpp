#include "texgen/preset/schema.h"

#include "texgen/maps/map.h"
#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"
#include "texgen/preset/loop_schema.h"
#include "texgen/preset/map_schema.h"
#include "texgen/preset/output_schema.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::int64_t kLargestSeed = std::numeric_limits<std::int64_t>::max();  // of TOML
constexpr int kLargestExtent = 16384;                                            // 1 GB of RGBA
constexpr bool kOrZero = true;
constexpr double kLargestTime = 1e6;
constexpr Choices<FoamKind> kFoamKinds = {
    {{{"torus", FoamKind::Torus}, {"patch", FoamKind::Patch}}}};
constexpr Choices<FirstFrame> kFirstFrames = {
    {{{"equilibrium", FirstFrame::Equilibrium}, {"diagram", FirstFrame::Diagram}}}};
constexpr Choices<Solver, 3> kSolvers = {{{{"newton", Solver::Newton},
                                           {"gauss-seidel", Solver::GaussSeidel},
                                           {"gauss-seidel-colored", Solver::ColoredGaussSeidel}}}};

using P = Preset;

/// One that only a kind of foam takes.
template <class... Parts>
Key key_of(FoamKind kind, const Parts&... parts) {
    Key one = key(parts...);
    one.kind = kind;
    return one;
}

std::vector<Key> description_keys() {
    return {key("preset.description",
                Text{.or_empty = true},
                "what the preset shows, in one line",
                &P::description)};
}

std::vector<Key> shape_keys() {
    return {key("foam.domain",
                kFoamKinds,
                "a torus, which tiles, or a patch with a free surface, on a transparent ground",
                &P::shape,
                &FoamShape::kind),
            key_of(FoamKind::Patch,
                   "foam.outline",
                   Outlines{},
                   "where a patch is seeded, scaled to an area of one per bubble; it then finds "
                   "its own shape",
                   &P::shape,
                   &FoamShape::outline),
            key_of(FoamKind::Patch,
                   "foam.outline_aspect",
                   Reals{1.0 / 16.0, 16.0},
                   "stretches the outline in x: width over height of a disc or a rectangle",
                   &P::shape,
                   &FoamShape::outline_aspect)};
}

std::vector<Key> foam_keys() {
    using Options = SeedingOptions;
    return {
        key("foam.bubbles",
            Integers{4, 1'000'000},
            "bubbles of the seeded foam, whose mean area is 1; of a patch about so many",
            &P::seeding,
            &Options::bubbles),
        key("foam.seed",
            Integers{0, kLargestSeed},
            "another seed, another foam of the same kind",
            &P::seeding,
            &Options::seed),
        key("foam.lloyd",
            Integers{0, 1000},
            "rounds of Lloyd relaxation: 0 is wild, 10 and more nearly regular",
            &P::seeding,
            &Options::lloyd_iterations),
        key("foam.area_ratio",
            Reals{1.0, 100.0, kOrZero},
            "largest over smallest bubble area; 0 leaves the areas as they fall",
            &P::seeding,
            &Options::area_ratio),
        key("foam.surface_tension",
            Reals{1e-6, 1e3},
            "gamma; a film pulls with twice this",
            &P::seeding,
            &Options::surface_tension),
        key("foam.solver",
            kSolvers,
            "what finds equilibrium: Newton's method, or the paper's own, in turn or on all "
            "threads, hundreds of times slower",
            &P::equilibrium,
            &SolverOptions::solver),
        key("foam.tolerance",
            Reals{1e-9, 1e-2},
            "largest error of areas, relative, and of angles, in radians; 1e-4 for gauss-seidel",
            &P::equilibrium,
            &SolverOptions::tolerance)};
}

std::vector<Key> dynamics_keys() {
    return {key("dynamics.kappa",
                Reals{0.0, 1000.0},
                "diffusion: dA/dt = (2 pi / 3) surface_tension kappa (sides - 6)",
                &P::coarsening,
                &CoarseningOptions::kappa),
            key("dynamics.t1_distance",
                Reals{0.001, 0.25},
                "a film shorter than this may swap neighbours, in foam units",
                &P::thresholds,
                &TopologyThresholds::t1_distance),
            key("dynamics.t2_area",
                Reals{0.0001, 0.25},
                "a three-sided bubble no larger than this vanishes, in foam units",
                &P::thresholds,
                &TopologyThresholds::t2_area)};
}

std::vector<Key> frames_keys() {
    using Options = FramesOptions;
    return {key("frames.count",
                Integers{1, 100'000},
                "frames of the animation",
                &P::frames,
                &Options::count),
            key("frames.first",
                kFirstFrames,
                "what frame 1 shows: the foam, or the diagram of straight films that it comes from",
                &P::frames,
                &Options::first),
            key("frames.time_step",
                Reals{0.0, kLargestTime},
                "foam time from one frame to the next",
                &P::frames,
                &Options::time_step),
            key("frames.step_growth",
                Reals{0.1, 10.0},
                "factor from each time step to the next: above 1 keeps up with a slowing foam",
                &P::frames,
                &Options::step_growth),
            key("frames.warm_up",
                Reals{0.0, kLargestTime},
                "foam time that passes before frame 1",
                &P::frames,
                &Options::warm_up)};
}

std::vector<Key> image_keys() {
    return {key("image.size", Sizes{kLargestExtent}, "pixels", &P::image),
            key("image.maps",
                WordLists{map_names()},
                "the images drawn of every frame",
                &P::image,
                &ImageOptions::maps)};
}

std::vector<Key> camera_keys() {
    using Options = CameraOptions;
    return {key_of(FoamKind::Patch,
                   "camera.zoom",
                   Reals{0.01, 1000.0},
                   "1 fits the patch of the first frame into the image; larger is closer",
                   &P::camera,
                   &Options::zoom),
            key_of(FoamKind::Patch,
                   "camera.center",
                   Points{{-10.0, 10.0}},
                   "what comes to the middle: a place in the image of zoom 1, in parts of it from "
                   "its lower left",
                   &P::camera,
                   &Options::center),
            key_of(FoamKind::Patch,
                   "camera.margin",
                   Reals{0.0, 0.45},
                   "left free around the patch at zoom 1, in parts of the image's shorter side",
                   &P::camera,
                   &Options::margin)};
}

std::vector<Key> all_keys() {
    std::vector<Key> all;
    for (const auto& keys : {description_keys(),
                             shape_keys(),
                             foam_keys(),
                             dynamics_keys(),
                             frames_keys(),
                             loop_keys(),
                             image_keys(),
                             camera_keys(),
                             map_keys(),
                             output_keys()}) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

}  // namespace

std::span<const Key> preset_keys() {
    static const std::vector<Key> keys = all_keys();
    return keys;
}

const Key* find_key(std::string_view path) {
    const auto keys = preset_keys();
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.path == path; });
    return found != keys.end() ? &*found : nullptr;
}

bool is_table(std::string_view name) {
    const auto keys = preset_keys();
    return std::any_of(
        keys.begin(), keys.end(), [&](const Key& key) { return key.table() == name; });
}

std::string_view name_of(FoamKind kind) {
    return kFoamKinds.name_of(kind);
}

}  // namespace foam::texgen
