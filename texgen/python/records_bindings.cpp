// SPDX-License-Identifier: Apache-2.0

#include "texgen/python/bindings.h"

#include <foamtex/errors.h>
#include <foamtex/records.h>

namespace foam::texgen {

namespace {

namespace py = pybind11;

// Registers a Python exception class for the C++ exception type ErrorKind. `bases` is the base
// class of the new class, or a tuple of base classes.
template <class ErrorKind>
py::object bind_error(py::module_& module,
                      const char* name,
                      const py::object& bases,
                      const char* meaning) {
    py::object error = py::register_exception<ErrorKind>(module, name, bases);
    error.doc() = meaning;
    return error;
}

const char* name_of(foamtex::EventKind kind) {
    switch (kind) {
        case foamtex::EventKind::T1:
            return "T1";
        case foamtex::EventKind::T2:
            return "T2";
        default:
            return "birth";
    }
}

py::object bases_of(const py::object& error, PyObject* builtin) {
    return py::make_tuple(error, py::reinterpret_borrow<py::object>(builtin));
}

}  // namespace

void bind_records(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(foamtex::Bubble,
                         identity,
                         sides,
                         x,
                         y,
                         area,
                         target_area,
                         pressure,
                         perimeter,
                         elongation,
                         orientation);
    PYBIND11_NUMPY_DTYPE(
        foamtex::Film, left, right, tail, head, x, y, chord_x, chord_y, half_angle, length);
    PYBIND11_NUMPY_DTYPE(foamtex::Point, x, y);

    using foamtex::Event;
    py::class_<Event>(module, "Event", "A change of topology: T1, T2, or the birth of a bubble.")
        .def_property_readonly(
            "kind",
            [](const Event& self) { return name_of(self.kind); },
            "\"T1\", \"T2\" or \"birth\".")
        .def_readonly("time", &Event::time, "Foam time.")
        .def_property_readonly(
            "position",
            [](const Event& self) { return py::make_tuple(self.position.x, self.position.y); },
            "The position of the change, as (x, y).")
        .def_readonly("bubbles",
                      &Event::bubbles,
                      "Identities of the bubbles whose neighbors changed. The first is the bubble "
                      "that vanished in a T2, or the bubble that was added in a birth.")
        .def("__repr__", [](const Event& self) {
            return py::str("Event({!r}, time={:.6g}, position=({:.6g}, {:.6g}), bubbles={})")
                .format(name_of(self.kind),
                        self.time,
                        self.position.x,
                        self.position.y,
                        py::cast(self.bubbles));
        });

    const py::object error =
        bind_error<foamtex::Error>(module,
                                   "Error",
                                   py::reinterpret_borrow<py::object>(PyExc_Exception),
                                   "The base of all errors of foamtex.");
    bind_error<foamtex::ArgumentError>(
        module,
        "ArgumentError",
        bases_of(error, PyExc_ValueError),
        "An argument or the value of a key is not allowed, or a preset file is unreadable or "
        "invalid.");
    bind_error<foamtex::InputError>(module,
                                    "InputError",
                                    bases_of(error, PyExc_ValueError),
                                    "A file cannot be read, or its content is malformed.");
    bind_error<foamtex::OutputError>(
        module,
        "OutputError",
        bases_of(error, PyExc_OSError),
        "A file cannot be written, or the operating system reports another error.");
    bind_error<foamtex::EquilibriumError>(module,
                                          "EquilibriumError",
                                          bases_of(error, PyExc_ArithmeticError),
                                          "No equilibrium was found, or a loop did not close.");
}

}  // namespace foam::texgen
