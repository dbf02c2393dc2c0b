// SPDX-License-Identifier: Apache-2.0

#include "texgen/python/bindings.h"

#include <foamtex/errors.h>
#include <foamtex/records.h>

namespace foam::texgen {

namespace {

namespace py = pybind11;

// Makes an exception of Python for a kind of errors, with the given base classes.
template <class ErrorKind>
py::object bind_error(py::module_& module,
                      const char* name,
                      const py::object& bases,
                      const char* meaning) {
    py::object error = py::register_exception<ErrorKind>(module, name, bases);
    error.doc() = meaning;
    return error;
}

py::object with_base(const py::object& error, PyObject* own) {
    return py::make_tuple(error, py::reinterpret_borrow<py::object>(own));
}

}  // namespace

void bind_records(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(
        foamtex::Bubble, identity, sides, x, y, area, target_area, pressure, perimeter);
    PYBIND11_NUMPY_DTYPE(
        foamtex::Film, left, right, tail, head, x, y, chord_x, chord_y, half_angle, length);
    PYBIND11_NUMPY_DTYPE(foamtex::Point, x, y);

    const py::object error =
        bind_error<foamtex::Error>(module,
                                   "Error",
                                   py::reinterpret_borrow<py::object>(PyExc_Exception),
                                   "The base of all errors of foamtex.");
    bind_error<foamtex::ArgumentError>(module,
                                       "ArgumentError",
                                       with_base(error, PyExc_ValueError),
                                       "An argument or the value of a key is not allowed.");
    bind_error<foamtex::InputError>(module,
                                    "InputError",
                                    with_base(error, PyExc_ValueError),
                                    "A file cannot be read, or its content is malformed.");
    bind_error<foamtex::OutputError>(
        module, "OutputError", with_base(error, PyExc_OSError), "A file cannot be written.");
    bind_error<foamtex::EquilibriumError>(module,
                                          "EquilibriumError",
                                          with_base(error, PyExc_ArithmeticError),
                                          "No equilibrium was found, or a loop did not close.");
}

}  // namespace foam::texgen
