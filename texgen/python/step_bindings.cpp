// SPDX-License-Identifier: Apache-2.0

#include "texgen/python/bindings.h"

#include <foamtex/foam.h>

namespace foam::texgen {

namespace {

namespace py = pybind11;
using foamtex::Equilibrium;
using foamtex::StepSettings;

void bind_equilibrium(py::module_& module) {
    py::class_<Equilibrium>(module, "Equilibrium", "The work and the result of relax() or step().")
        .def_readonly("iterations", &Equilibrium::iterations, "Iterations of Newton's method.")
        .def_readonly("t1", &Equilibrium::t1, "Number of T1s, in which bubbles swap neighbors.")
        .def_readonly("t2", &Equilibrium::t2, "Number of T2s: bubbles that vanished.")
        .def_readonly("area_error", &Equilibrium::area_error, "Largest |area / target area - 1|.")
        .def_readonly("angle_error",
                      &Equilibrium::angle_error,
                      "Largest deviation of an angle from 120 degrees, in radians.")
        .def("__repr__", [](const Equilibrium& found) {
            return py::str(
                       "Equilibrium(iterations={}, t1={}, t2={}, area_error={:.1e}, "
                       "angle_error={:.1e})")
                .format(found.iterations, found.t1, found.t2, found.area_error, found.angle_error);
        });
}

void bind_settings(py::module_& module) {
    py::class_<StepSettings>(module, "StepSettings", "How a time step is computed.")
        .def(py::init([](double kappa,
                         double tolerance,
                         double t1_distance,
                         double t2_area,
                         int threads) {
                 return StepSettings{kappa, tolerance, t1_distance, t2_area, threads};
             }),
             py::kw_only(),
             py::arg("kappa") = StepSettings().kappa,
             py::arg("tolerance") = StepSettings().tolerance,
             py::arg("t1_distance") = StepSettings().t1_distance,
             py::arg("t2_area") = StepSettings().t2_area,
             py::arg("threads") = 0)
        .def("__repr__",
             [](const StepSettings& self) {
                 return py::str(
                            "StepSettings(kappa={}, tolerance={}, t1_distance={}, t2_area={}, "
                            "threads={})")
                     .format(
                         self.kappa, self.tolerance, self.t1_distance, self.t2_area, self.threads);
             })
        .def_readwrite("kappa", &StepSettings::kappa, "Diffusion constant, in foam units.")
        .def_readwrite(
            "tolerance",
            &StepSettings::tolerance,
            "Largest allowed error of areas (relative) and of angles (radians) in equilibrium.")
        .def_readwrite("t1_distance",
                       &StepSettings::t1_distance,
                       "A film may flip (T1) if its chord is shorter than this, in foam units.")
        .def_readwrite(
            "t2_area",
            &StepSettings::t2_area,
            "A bubble may vanish (T2) if its target area is at most this, in square foam units.")
        .def_readwrite("threads",
                       &StepSettings::threads,
                       "Number of threads; 0 stands for all threads of the machine.");
}

}  // namespace

void bind_steps(py::module_& module) {
    bind_equilibrium(module);
    bind_settings(module);
}

}  // namespace foam::texgen
