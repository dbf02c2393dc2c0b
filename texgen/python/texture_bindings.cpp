// SPDX-License-Identifier: Apache-2.0

#include "texgen/api/frame_images.h"
#include "texgen/api/public_errors.h"
#include "texgen/python/arrays.h"
#include "texgen/python/bindings.h"

#include <foamtex/texture.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace foam::texgen {

namespace {

namespace py = pybind11;

// Returns a value of Python as the text of a TOML value: True becomes true, and a list or a tuple
// becomes a list. A str is returned unchanged and is then read like a value on the command line; a
// str in a list or a tuple is quoted.
std::string value_text(const py::handle& value) {
    if (py::isinstance<py::str>(value)) {
        return value.cast<std::string>();
    }
    if (value.is_none()) {
        throw foamtex::ArgumentError("the value of a key must not be None");
    }
    if (py::hasattr(value, "tolist")) {  // an array or a number of NumPy
        return value_text(value.attr("tolist")());
    }
    if (py::isinstance<py::bool_>(value)) {
        return value.cast<bool>() ? "true" : "false";
    }
    if (py::isinstance<py::sequence>(value)) {
        std::string text;
        for (const py::handle item : value) {
            const bool is_text = py::isinstance<py::str>(item);
            text += (text.empty() ? "" : ", ") +
                    (is_text ? to_toml(Value{item.cast<std::string>()}) : value_text(item));
        }
        return "[" + text + "]";
    }
    return py::str(value).cast<std::string>();
}

std::map<std::string, std::string> values_of(const py::dict& values) {
    std::map<std::string, std::string> texts;
    for (const auto& [key, value] : values) {
        texts[key.cast<std::string>()] = value_text(value);
    }
    return texts;
}

// Deletes a simulation. Lets other threads of Python run meanwhile, because the destructor of the
// simulation waits for the end of the step that is being computed.
struct SimulationDeleter {
    void operator()(foamtex::Simulation* simulation) const {
        const py::gil_scoped_release others_may_run;
        delete simulation;
    }
};
using OwnedSimulation = std::unique_ptr<foamtex::Simulation, SimulationDeleter>;

foamtex::Frame next_frame(foamtex::Simulation& simulation) {
    std::optional<foamtex::Frame> frame;
    {
        const py::gil_scoped_release others_may_run;
        frame = simulation.next(throw_if_interrupted);
    }
    if (!frame) {
        throw py::stop_iteration();
    }
    return *std::move(frame);
}

template <class Draw>
py::array array_drawn_by(const Draw& draw) {
    auto image = [&] {
        const py::gil_scoped_release others_may_run;
        return with_texture_errors(draw);
    }();
    return array_of(std::move(image));
}

py::array draw_map(const foamtex::Frame& frame,
                   const std::string& map,
                   const py::object& dtype,
                   int threads) {
    const py::dtype type = py::dtype::from_args(dtype);
    const foamtex::Frame::State& state = frame.state();
    if (type.equal(py::dtype::of<float>())) {
        return array_drawn_by([&] { return number_image(state, map, threads); });
    }
    if (type.equal(py::dtype::of<std::uint8_t>())) {
        return array_drawn_by([&] { return code_image<std::uint8_t>(state, map, threads); });
    }
    if (type.equal(py::dtype::of<std::uint16_t>())) {
        return array_drawn_by([&] { return code_image<std::uint16_t>(state, map, threads); });
    }
    throw foamtex::ArgumentError("dtype must be float32, uint8 or uint16");
}

template <auto member>
py::array frame_table(const py::object& self) {
    return view_of(self.cast<const foamtex::Frame&>().records().*member, self);
}

// Fits the automatic ranges of the maps in a copy of the preset. Does not hold the GIL meanwhile,
// so that other threads may use the preset. If another thread has changed the preset meanwhile, the
// copy is dropped, because ranges that were fitted before a call of `set` are not valid after it.
void fit_ranges(foamtex::Preset& preset, int threads) {
    const foamtex::Preset before = preset;
    foamtex::Preset fitted = preset;
    {
        const py::gil_scoped_release others_may_run;
        fitted.fit_ranges(threads);
    }
    if (&preset.state() == &before.state()) {
        preset = std::move(fitted);
    }
}

void bind_preset(py::module_& module) {
    py::class_<foamtex::Preset>(module,
                                "Preset",
                                "All options of an animation. Loads a shipped preset, such as "
                                "\"sea_foam\", or a preset file, and then sets the keys in "
                                "`values`.")
        .def(py::init([](const std::filesystem::path& name_or_path, const py::dict& values) {
                 return foamtex::Preset(name_or_path.string(), values_of(values));
             }),
             py::arg("name_or_path"),
             py::arg("values") = py::dict())
        .def(
            "set",
            [](foamtex::Preset& self, const py::dict& values) { self.set(values_of(values)); },
            "Sets keys, such as {\"foam.bubbles\": 300}. If a key or a value is not allowed, no "
            "key "
            "is set.",
            py::arg("values"))
        .def("get",
             &foamtex::Preset::get,
             "The value of a key as TOML; None if the key is unset.",
             py::arg("key"))
        .def_property_readonly("name", &foamtex::Preset::name)
        .def_property_readonly("description", &foamtex::Preset::description)
        .def_property_readonly(
            "frame_count", &foamtex::Preset::frame_count, "Number of frames of the animation.")
        .def_property_readonly(
            "maps", &foamtex::Preset::maps, "Names of the maps in the key image.maps.")
        .def_property_readonly("width", &foamtex::Preset::width, "Width of images, in pixels.")
        .def_property_readonly("height", &foamtex::Preset::height, "Height of images, in pixels.")
        .def("toml", &foamtex::Preset::toml, "The whole preset as the text of a preset file.")
        .def(
            "simulate",
            [](const foamtex::Preset& self, const std::optional<std::string>& frames, int threads) {
                return OwnedSimulation(new foamtex::Simulation(self, frames.value_or(""), threads));
            },
            "Starts the simulation and returns an iterator of its frames. `frames` selects "
            "the frames to return, such as \"1-48\"; by default, all of them. A thread computes a "
            "few frames ahead.",
            py::arg("frames") = py::none(),
            py::kw_only(),
            py::arg("threads") = 0)
        .def("fit_ranges",
             &fit_ranges,
             "Fits the automatic ranges of the maps in image.maps and output.pack to the whole "
             "animation. To draw a map with an automatic range as integers, call this function "
             "before `simulate`, and again after each call of `set`. If another thread calls `set` "
             "meanwhile, no range is fitted.",
             py::kw_only(),
             py::arg("threads") = 0)
        .def("__repr__", [](const foamtex::Preset& self) {
            return py::str("Preset({!r})").format(self.name());
        });
}

}  // namespace

void bind_texture(py::module_& module) {
    py::class_<foamtex::Simulation, OwnedSimulation>(
        module, "Simulation", "An iterator of the frames of a preset.")
        .def("__iter__", [](const py::object& self) { return self; })
        .def("__next__", &next_frame);
    py::class_<foamtex::Frame>(
        module,
        "Frame",
        "One frame of an animation: a foam, and its images. Several threads may use it.")
        .def("map",
             &draw_map,
             "Draws a map and returns an array of height x width x channels, with the top row "
             "first. With float32, samples are numbers in the unit of the map; samples of a map of "
             "colors are linear light from 0 to 1, multiplied by the opacity if the map has one. "
             "With uint8 or uint16, samples are the integers that a PNG of this depth contains. (A "
             "bake may write the map with another depth.) Maps of colors do not allow uint16.",
             py::arg("name"),
             py::arg("dtype") = py::dtype::of<float>(),
             py::kw_only(),
             py::arg("threads") = 1)
        .def_property_readonly("number", &foamtex::Frame::number, "Number of the frame, from 1.")
        .def_property_readonly("time", &foamtex::Frame::time, "Foam time.")
        .def_property_readonly("energy",
                               &foamtex::Frame::energy,
                               "Film tension times the length of all films of the simulated foam.")
        .def_property_readonly("bubbles",
                               &frame_table<&foamtex::FoamRecords::bubbles>,
                               "Structured array, as Foam.bubbles; a view that cannot be written.")
        .def_property_readonly("films",
                               &frame_table<&foamtex::FoamRecords::films>,
                               "Structured array, as Foam.films; a view that cannot be written.")
        .def_property_readonly(
            "junctions",
            &frame_table<&foamtex::FoamRecords::junctions>,
            "Structured array, as Foam.junctions; a view that cannot be written.")
        .def_property_readonly(
            "events",
            &foamtex::Frame::events,
            "The changes of topology since the frame that the simulation returned before this "
            "one, or since the start of the simulation, as a list of Event.")
        .def(
            "stress",
            [](const foamtex::Frame& self) { return matrix_of(self.stress()); },
            "The mean stress as an array of shape (2, 2); tension is positive.")
        .def("__repr__",
             [](const foamtex::Frame& self) { return py::str("Frame({})").format(self.number()); });
    bind_preset(module);
}

}  // namespace foam::texgen
