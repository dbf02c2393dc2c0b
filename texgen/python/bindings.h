// SPDX-License-Identifier: Apache-2.0

#pragma once

// Every source file of the module includes this header, because pybind11 requires the same type
// casters in all of these files.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace foam::texgen {

/// These functions add the parts of the module: records and errors, settings and results of steps,
/// the class Foam, presets with their images, and functions that bake, compare images, write PNGs
/// and list presets and maps. A class must be added before functions whose default arguments are
/// objects of this class.
void bind_records(pybind11::module_& module);
void bind_steps(pybind11::module_& module);
void bind_foam(pybind11::module_& module);
void bind_texture(pybind11::module_& module);
void bind_files(pybind11::module_& module);

/// Lets Ctrl-C end a long computation, which must call this function now and then: calls Python's
/// signal handlers, and throws the exception that they raise. Precondition: this thread does not
/// hold the GIL.
inline void throw_if_interrupted() {
    const pybind11::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) {
        throw pybind11::error_already_set();
    }
}

}  // namespace foam::texgen
