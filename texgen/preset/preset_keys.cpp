// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_keys.h"

#include "texgen/keys/nearest.h"
#include "texgen/keys/parsed_texts.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/preset/key_values.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

// The largest integer that TOML can represent.
constexpr std::int64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();

Keys<SeedingOptions> seeding_keys() {
    using Options = SeedingOptions;
    return {
        key("bubbles",
            Integers{4, 1'000'000},
            "number of bubbles of the seeded foam (approximate for a patch); the mean bubble area "
            "is 1",
            &Options::bubbles)
            .in("bubbles"),
        key("seed",
            Integers{0, kMaxSeed},
            "seed of the random numbers; each seed gives a different foam of the same kind",
            &Options::seed),
        key("lloyd",
            Integers{0, 1000},
            "rounds of Lloyd relaxation of the random diagram: 0 gives an irregular foam, 10 or "
            "more a nearly regular one",
            &Options::lloyd_iterations)
            .in("rounds"),
        key("area_ratio",
            Reals{.low = 1.0, .high = 100.0, .or_zero = true},
            "ratio of the largest to the smallest bubble area; 0 keeps the areas of the random "
            "diagram",
            &Options::area_ratio),
        key("surface_tension",
            Reals{1e-6, 1e3},
            "surface tension gamma; the tension of a film is twice this value",
            &Options::surface_tension)};
}

Keys<SolverOptions> solver_keys() {
    constexpr Choices<Solver, 3> kSolvers = {
        {{{"newton", Solver::Newton},
          {"gauss-seidel", Solver::GaussSeidel},
          {"gauss-seidel-colored", Solver::ColoredGaussSeidel}}}};
    return {key("solver",
                kSolvers,
                "solver of the equilibrium: Newton's method, or the solver of the paper on one "
                "thread or on all threads; the solver of the paper is hundreds of times slower",
                &SolverOptions::solver),
            key("tolerance",
                Reals{1e-9, 1e-2},
                "largest relative error of areas and largest error of angles, in radians; use 1e-4 "
                "for gauss-seidel",
                &SolverOptions::tolerance)
                .in("fraction of the area, and radians")};
}

Keys<CoarseningOptions> coarsening_keys() {
    return {key("kappa",
                Reals{0.0, 1000.0},
                "diffusion constant: dA/dt = (2 pi / 3) surface_tension kappa (sides - 6); in "
                "loops of the kinds breathe, shear, boil and drift, gas diffuses only during "
                "frames.warm_up",
                &CoarseningOptions::kappa)
                .in("square foam units per foam time, for a surface tension of 1")};
}

Keys<TopologyThresholds> threshold_keys() {
    return {key("t1_distance",
                Reals{0.001, 0.25},
                "chord length, in foam units, below which a film may flip (T1: neighbors swap)",
                &TopologyThresholds::t1_distance)
                .in("foam units"),
            key("t2_area",
                Reals{0.0001, 0.25},
                "target area, in square foam units, at or below which a bubble of two or three "
                "sides, or a lone bubble of a patch, vanishes (T2)",
                &TopologyThresholds::t2_area)
                .in("square foam units")};
}

// Parses an item of preset.vary. Throws std::invalid_argument with a message that begins with the
// item. Does not check that the key allows the values; see check_varied_keys.
KeyValues parse_item(std::string_view text) {
    try {
        return parse_key_values(text);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("'{}': {}", text, error.what()));
    }
}

// The keys about the preset itself.
Keys<Preset> own_keys() {
    return {key("preset.description",
                Text{.or_empty = true},
                "what the preset shows, in one line",
                &Preset::description),
            key("preset.vary",
                ParsedTexts<parse_item>{"a list of texts KEY=VALUES, such as "
                                        "\"foam.lloyd=0,1,4\" or \"loop.amplitude=0.1..0.4\""},
                "keys that are worth varying, and good values of them: foamtex vary --random draws "
                "values from these lists and ranges",
                &Preset::vary)};
}

Keys<Preset> all_keys() {
    using P = Preset;
    return joined({own_keys(),
                   nested_keys("foam", &P::shape, shape_keys()),
                   nested_keys("foam", &P::seeding, seeding_keys()),
                   nested_keys("foam", &P::density, density_keys()),
                   nested_keys("foam", &P::equilibrium, solver_keys()),
                   nested_keys("dynamics", &P::coarsening, coarsening_keys()),
                   nested_keys("dynamics", &P::thresholds, threshold_keys()),
                   nested_keys("frames", &P::frames, frames_keys()),
                   nested_keys("loop", &P::loop, loop_keys()),
                   nested_keys("image", &P::image, image_keys()),
                   nested_keys("camera", &P::camera, camera_keys()),
                   nested_keys("", &P::maps, map_keys()),
                   nested_keys("output", &P::output, output_keys()),
                   nested_keys("vector", &P::vector, vector_keys()),
                   nested_keys("mesh", &P::mesh, mesh_keys())});
}

}  // namespace

std::span<const Key<Preset>> preset_keys() {
    static const Keys<Preset> keys = all_keys();
    return keys;
}

const Key<Preset>* find_key(std::string_view path) {
    return find_key(preset_keys(), path);
}

std::vector<NamedFile> files_of(const Preset& preset) {
    std::vector<NamedFile> files;
    for (const Key<Preset>& key : preset_keys()) {
        if (std::optional<NamedFile> file = key.file ? key.file(preset) : std::nullopt) {
            files.push_back(*std::move(file));
        }
    }
    return files;
}

std::string file_hashes(const Preset& preset) {
    std::string text;
    for (const NamedFile& file : files_of(preset)) {
        text += file.hash + '\n';
    }
    return text;
}

void locate_files(std::span<Assignment> assignments,
                  const std::function<std::string(const std::string& path)>& located) {
    for (Assignment& assignment : assignments) {
        const Key<Preset>* const key = find_key(assignment.key);
        if (key != nullptr && key->names_file && key->names_file(assignment.value)) {
            auto& path = std::get<std::string>(assignment.value.data);
            path = located(path);
        }
    }
}

std::string_view nearest_key(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('.') + 1);
    std::vector<std::string_view> paths;
    for (const KeyInfo& key : preset_keys()) {
        if (key.name() == name) {
            return key.path;
        }
        paths.push_back(key.path);
    }
    return nearest(path, paths);
}

bool is_table(std::string_view name) {
    const auto keys = preset_keys();
    return std::any_of(keys.begin(), keys.end(), [&](const KeyInfo& key) {
        return key.path.size() > name.size() && key.path.starts_with(name) &&
               key.path[name.size()] == '.';
    });
}

}  // namespace foam::texgen
