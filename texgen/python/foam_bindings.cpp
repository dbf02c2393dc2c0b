// SPDX-License-Identifier: Apache-2.0

#include "texgen/python/arrays.h"
#include "texgen/python/bindings.h"
#include "texgen/python/shared_foam.h"

#include <foamtex/foam.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

namespace foam::texgen {

namespace {

namespace py = pybind11;
using foamtex::Drive;
using foamtex::Equilibrium;
using foamtex::FoamRecords;
using foamtex::SeedOptions;
using foamtex::StepSettings;

using FoamPointer = std::shared_ptr<SharedFoam>;

FoamPointer make_shared_foam(foamtex::Foam foam) {
    return std::make_shared<SharedFoam>(std::move(foam));
}

template <class Make>
FoamPointer make_without_gil(const Make& make) {
    const py::gil_scoped_release others_may_run;
    return make_shared_foam(make());
}

SeedOptions seed_options(int bubbles,
                         int lloyd_iterations,
                         double area_ratio,
                         double surface_tension,
                         std::uint64_t seed) {
    return {.bubbles = bubbles,
            .lloyd_iterations = lloyd_iterations,
            .area_ratio = area_ratio,
            .surface_tension = surface_tension,
            .seed = seed};
}

// A push as Python gives it: the center, the radius, and the displacement of the center.
using Pair = std::array<double, 2>;
using PushTuple = std::tuple<Pair, double, Pair>;

Drive drive_of(const std::map<std::int64_t, double>& areas,
               double strain,
               const std::vector<PushTuple>& pushes) {
    Drive drive{.strain = strain};
    for (const auto& [identity, area] : areas) {
        drive.areas.push_back({identity, area});
    }
    for (const auto& [center, radius, shift] : pushes) {
        drive.pushes.push_back({{center[0], center[1]}, radius, {shift[0], shift[1]}});
    }
    return drive;
}

Equilibrium require_converged(const Equilibrium& found) {
    if (!found.converged) {
        throw foamtex::EquilibriumError("the foam found no equilibrium");
    }
    return found;
}

void check_evolver_name(const std::string& file) {
    if (!file.ends_with(".fe") && !file.ends_with(".dmp")) {
        throw foamtex::ArgumentError(
            "'" + file + "': the name of a file of Surface Evolver ends in .fe or .dmp");
    }
}

using FoamClass = py::class_<SharedFoam, FoamPointer>;

void bind_making(FoamClass& foam) {
    foam.def_static(
            "torus",
            [](int bubbles,
               double aspect,
               int lloyd_iterations,
               double area_ratio,
               double surface_tension,
               std::uint64_t seed) {
                SeedOptions options =
                    seed_options(bubbles, lloyd_iterations, area_ratio, surface_tension, seed);
                options.aspect = aspect;
                return make_without_gil([&] { return foamtex::Foam::torus(options); });
            },
            "The Voronoi diagram of random points on a torus of area `bubbles`, not yet in "
            "equilibrium: call relax().",
            py::arg("bubbles") = 1000,
            py::kw_only(),
            py::arg("aspect") = 1.0,
            py::arg("lloyd_iterations") = 0,
            py::arg("area_ratio") = 0.0,
            py::arg("surface_tension") = 0.5,
            py::arg("seed") = 1)
        .def_static(
            "disk",
            [](int bubbles,
               int lloyd_iterations,
               double area_ratio,
               double surface_tension,
               std::uint64_t seed) {
                const SeedOptions options =
                    seed_options(bubbles, lloyd_iterations, area_ratio, surface_tension, seed);
                return make_without_gil([&] { return foamtex::Foam::disk(options); });
            },
            "A free patch that is seeded in a disk, not yet in equilibrium: call relax().",
            py::arg("bubbles") = 100,
            py::kw_only(),
            py::arg("lloyd_iterations") = 0,
            py::arg("area_ratio") = 0.0,
            py::arg("surface_tension") = 0.5,
            py::arg("seed") = 1)
        .def_static(
            "read",
            [](const std::filesystem::path& file) {
                return make_without_gil([&] { return foamtex::Foam::read(file.string()); });
            },
            "Reads a foam from a file: .fe or .dmp of Surface Evolver, or .json, a state of "
            "foamtex.",
            py::arg("file"))
        .def_static(
            "from_evolver",
            [](const std::filesystem::path& file) {
                check_evolver_name(file.string());
                return make_without_gil([&] { return foamtex::Foam::read(file.string()); });
            },
            "Reads a data file of Surface Evolver, .fe or .dmp.",
            py::arg("file"))
        .def_static(
            "from_state",
            [](const std::string& json) {
                return make_without_gil([&] { return foamtex::Foam::from_state(json); });
            },
            "Makes a foam from the text that state() returns.",
            py::arg("json"));
}

void bind_actions(FoamClass& foam) {
    foam.def(
            "write",
            [](SharedFoam& self, const std::filesystem::path& file) {
                self.use([&](const foamtex::Foam& one) { one.write(file.string()); });
            },
            "Writes the foam. The ending of the name selects the format, as in read().",
            py::arg("file"))
        .def(
            "to_evolver",
            [](SharedFoam& self, const std::filesystem::path& file) {
                check_evolver_name(file.string());
                self.use([&](const foamtex::Foam& one) { one.write(file.string()); });
            },
            "Writes a data file of Surface Evolver, .fe or .dmp, with exact arcs.",
            py::arg("file"))
        .def(
            "state",
            [](SharedFoam& self) {
                return self.use([](const foamtex::Foam& one) { return one.state(); });
            },
            "The state as JSON, without the events that take_events() would return. A foam that "
            "from_state() makes from it evolves exactly like this foam.")
        .def(
            "copy",
            [](SharedFoam& self) {
                return make_shared_foam(self.use([](const foamtex::Foam& one) { return one; }));
            },
            "An independent copy.")
        .def(
            "relax",
            [](SharedFoam& self, int threads) {
                return require_converged(self.change(
                    [&](foamtex::Foam& one) { return one.relax(threads, throw_if_interrupted); }));
            },
            "Brings the foam to equilibrium at its target areas, to errors below 1e-9. Raises "
            "EquilibriumError if this fails. After this error or Ctrl-C, the foam is unchanged.",
            py::kw_only(),
            py::arg("threads") = 0)
        .def(
            "step",
            [](SharedFoam& self,
               double time,
               const std::map<std::int64_t, double>& areas,
               double strain,
               const std::vector<PushTuple>& pushes,
               const StepSettings& settings) {
                const Drive drive = drive_of(areas, strain, pushes);
                return require_converged(self.change([&](foamtex::Foam& one) {
                    return one.step(time, drive, settings, throw_if_interrupted);
                }));
            },
            "Advances the foam by the foam time `time`: gas diffuses, bubbles vanish (T2) and swap "
            "neighbors (T1). `areas` maps identities of bubbles to target areas at the end of the "
            "step; `strain` is simple shear along x; each of `pushes` is (center, radius, "
            "displacement of the center). Raises EquilibriumError if no equilibrium is found; the "
            "foam is then in the last equilibrium that the step reached. After Ctrl-C, the foam is "
            "unchanged.",
            py::arg("time"),
            py::kw_only(),
            py::arg("areas") = std::map<std::int64_t, double>(),
            py::arg("strain") = 0.0,
            py::arg("pushes") = std::vector<PushTuple>(),
            py::arg("settings") = StepSettings())
        .def(
            "shear",
            [](SharedFoam& self, double strain) {
                self.change([&](foamtex::Foam& one) { one.shear(strain); });
            },
            "Shears a torus without restoring equilibrium: every point moves right by strain * y.",
            py::arg("strain"));
}

void bind_values(FoamClass& foam) {
    foam.def_property_readonly(
            "time",
            [](SharedFoam& self) { return self.use([](const auto& one) { return one.time(); }); },
            "Foam time.")
        .def_property_readonly(
            "energy",
            [](SharedFoam& self) { return self.use([](const auto& one) { return one.energy(); }); },
            "Film tension times the length of all films.")
        .def_property_readonly(
            "film_tension",
            [](SharedFoam& self) {
                return self.use([](const auto& one) { return one.film_tension(); });
            },
            "Tension of a film, two times the surface tension.")
        .def_property_readonly(
            "periods",
            [](SharedFoam& self) -> std::optional<std::array<Pair, 2>> {
                const foamtex::Extent extent =
                    self.use([](const auto& one) { return one.extent(); });
                if (!extent.is_torus()) {
                    return std::nullopt;
                }
                return std::array{Pair{extent.width, 0.0}, Pair{extent.shear, extent.height}};
            },
            "The two periods of a torus, as vectors; None for a patch.")
        .def(
            "stress",
            [](SharedFoam& self) {
                return matrix_of(self.use([](const auto& one) { return one.stress(); }));
            },
            "The mean stress as an array of shape (2, 2); tension is positive.")
        .def(
            "shear_modulus",
            [](SharedFoam& self, int threads) {
                return self.use([&](const auto& one) { return one.shear_modulus(threads); });
            },
            "Derivative of the shear stress of a torus in equilibrium with respect to strain, "
            "without T1s. It is None for a patch, for a foam with an error of areas or angles "
            "above 1e-3, and if Newton's method fails.",
            py::kw_only(),
            py::arg("threads") = 0)
        .def(
            "take_events",
            [](SharedFoam& self) {
                return self.change([](auto& one) { return one.take_events(); });
            },
            "The changes of topology since the last call, as a list of Event.")
        .def_property_readonly(
            "bubbles",
            &table_of<&FoamRecords::bubbles>,
            "Structured array: identity, sides, x, y, area, target_area, pressure, "
            "perimeter, elongation, orientation.")
        .def_property_readonly(
            "films",
            &table_of<&FoamRecords::films>,
            "Structured array: left, right (indices of bubbles, -1 outside), tail, head (indices "
            "of junctions), x, y (of the tail), chord_x, chord_y, half_angle, length.")
        .def_property_readonly(
            "junctions", &table_of<&FoamRecords::junctions>, "Structured array: x, y.")
        .def("__len__", [](SharedFoam& self) {
            return self.use([](const auto& one) { return one.bubble_count(); });
        });
}

}  // namespace

void bind_foam(py::module_& module) {
    FoamClass foam(
        module,
        "Foam",
        "A two-dimensional dry foam, on a torus or as a free patch. Lengths are in foam units: the "
        "mean bubble area of a seeded foam is 1. Slow functions release the GIL.");
    bind_making(foam);
    bind_actions(foam);
    bind_values(foam);
}

}  // namespace foam::texgen
