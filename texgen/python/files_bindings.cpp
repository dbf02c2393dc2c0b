// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "core/library/with_public_errors.h"
#include "texgen/image/png.h"
#include "texgen/python/bindings.h"

#include <foamtex/texture.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

namespace py = pybind11;
using foamtex::Difference;
using foamtex::Progress;

// `preset` is a copy, because other threads of Python may change the original meanwhile.
std::vector<std::string> bake(
    foamtex::Preset preset,  // NOLINT(performance-unnecessary-value-param)
    const std::filesystem::path& out,
    const std::optional<std::string>& frames,
    int threads,
    bool resume,
    const py::object& progress) {
    foamtex::BakeSettings settings{
        .frames = frames.value_or(""), .threads = threads, .resume = resume};
    settings.on_progress = [&progress](const Progress& now) {
        const py::gil_scoped_acquire python;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (!progress.is_none()) {
            progress(now);
        }
    };
    const py::gil_scoped_release others_may_run;
    return foamtex::bake(preset, out.string(), settings);
}

std::vector<Difference> compare(const std::filesystem::path& a,
                                const std::filesystem::path& b,
                                const foamtex::Limits& limits,
                                const std::optional<std::filesystem::path>& picture) {
    const py::gil_scoped_release others_may_run;
    return foamtex::compare(
        a.string(), b.string(), limits, picture.value_or(std::filesystem::path()).string());
}

// Copies an array of the shape (height, width, channels), whose first row is the top row, to an
// image, and returns the image.
template <class Sample>
Image<Sample> image_of(const py::array& given) {
    const auto array = py::array_t<Sample>::ensure(given);
    const auto pixels = array.template unchecked<3>();
    Image<Sample> image(static_cast<int>(pixels.shape(1)),
                        static_cast<int>(pixels.shape(0)),
                        static_cast<int>(pixels.shape(2)));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int channel = 0; channel < image.channels(); ++channel) {
                image.pixel(x, image.height() - 1 - y)[static_cast<std::size_t>(channel)] =
                    pixels(y, x, channel);
            }
        }
    }
    return image;
}

void write_png_file(const std::filesystem::path& file, const py::array& array) {
    const bool is_8_bit = array.dtype().equal(py::dtype::of<std::uint8_t>());
    const bool is_16_bit = array.dtype().equal(py::dtype::of<std::uint16_t>());
    if (!(is_8_bit || is_16_bit) || array.ndim() != 3 || array.shape(2) > 4 || array.size() == 0) {
        throw foamtex::ArgumentError(
            "write_png: the array must have the type uint8 or uint16 and the shape (height, width, "
            "channels) with 1 to 4 channels");
    }
    with_public_errors([&] {
        const Bytes stream = is_8_bit ? encode_png(image_of<std::uint8_t>(array).view(), {})
                                      : encode_png(image_of<std::uint16_t>(array).view(), {});
        write_file(file, stream);
    });
}

}  // namespace

void bind_files(py::module_& module) {
    py::class_<Progress>(module, "Progress", "The progress of a bake.")
        .def_readonly("phase", &Progress::phase, "Name of the phase, such as \"frames\".")
        .def_readonly("done", &Progress::done, "Number of units of the phase that are done.")
        .def_readonly("total", &Progress::total, "Number of units of the phase; 0 if unknown.")
        .def_readonly(
            "frame", &Progress::frame, "The frame that was done last; 0 if there is none.")
        .def("__str__", [](const Progress& self) {
            return py::str("{} {}/{}").format(self.phase, self.done, self.total);
        });
    py::class_<Difference>(
        module, "Difference", "The comparison of two images, or of one layer of two images.")
        .def_readonly("is_within", &Difference::is_within, "True if no limit is exceeded.")
        .def_readonly("same_shape",
                      &Difference::same_shape,
                      "False if size or channels differ; nothing is compared then.")
        .def_readonly("map", &Difference::map, "Name of the map; empty if unknown.")
        .def_readonly(
            "layer", &Difference::layer, "Name of the layer; empty if the images have no layers.")
        .def_readonly("largest", &Difference::largest, "Largest difference of two samples.")
        .def_readonly("mean", &Difference::mean, "Mean difference of all samples.")
        .def_readonly("rms", &Difference::rms, "Root mean square of the differences.")
        .def_readonly("channel", &Difference::channel, "Channel of the largest difference.")
        .def_readonly("x", &Difference::x, "Column of the largest difference.")
        .def_readonly("y", &Difference::y, "Row of the largest difference, from the top.")
        .def_readonly("reasons",
                      &Difference::reasons,
                      "The limits that are exceeded, in words; if same_shape is False, a sentence "
                      "that says so.")
        .def("__bool__", [](const Difference& self) { return self.is_within; })
        .def("__repr__", [](const Difference& self) {
            return py::str("Difference(is_within={}, same_shape={}, largest={:.3g}, rms={:.3g})")
                .format(self.is_within, self.same_shape, self.largest, self.rms);
        });
    module.def(
        "bake",
        &bake,
        "Writes the images of a preset, as `foamtex bake` does, and returns their names. "
        "`out` is a folder or a pattern of file names. `frames` are numbers such as \"1-48\"; "
        "by default all. `resume` keeps frames that an earlier bake of the same preset has "
        "written. `progress` is called with a Progress now and then.",
        py::arg("preset"),
        py::arg("out"),
        py::kw_only(),
        py::arg("frames") = py::none(),
        py::arg("threads") = 0,
        py::arg("resume") = false,
        py::arg("progress") = py::none());
    module.def(
        "compare",
        [](const std::filesystem::path& a,
           const std::filesystem::path& b,
           std::optional<double> sample,
           std::optional<double> rms,
           std::optional<double> angle,
           double allowed_percent,
           const std::optional<std::filesystem::path>& picture) {
            return compare(a, b, {sample, rms, angle, allowed_percent}, picture);
        },
        "Compares two image files and returns a Difference per layer. `sample` limits the "
        "difference of any sample, `rms` the root mean square of the differences, and `angle` the "
        "angle between normals, in degrees. If none of these three limits is given, samples may "
        "differ by at most 1e-6. "
        "`allowed_percent` is the percentage of pixels that may exceed `sample` or `angle`. "
        "If `picture` is given, a picture of the differences is written to a PNG of this name, "
        "unless the images differ in size or channels.",
        py::arg("a"),
        py::arg("b"),
        py::kw_only(),
        py::arg("sample") = py::none(),
        py::arg("rms") = py::none(),
        py::arg("angle") = py::none(),
        py::arg("allowed_percent") = 0.0,
        py::arg("picture") = py::none());
    module.def("write_png",
               &write_png_file,
               "Writes an array of uint8 or uint16, height x width x channels, as a PNG.",
               py::arg("file"),
               py::arg("array"));
    py::class_<foamtex::MapInfo>(module, "MapInfo", "A map that can be drawn of a frame.")
        .def_readonly("name", &foamtex::MapInfo::name)
        .def_readonly("meaning", &foamtex::MapInfo::meaning)
        .def_readonly("unit", &foamtex::MapInfo::unit)
        .def_readonly("channels", &foamtex::MapInfo::channels)
        .def("__repr__", [](const foamtex::MapInfo& self) {
            return py::str("MapInfo({!r})").format(self.name);
        });
    module.def("presets", &foamtex::preset_names, "Names of the shipped presets.");
    module.def("maps", &foamtex::maps, "All maps, as a list of MapInfo.");
    module.def("_key_schema", &foamtex::key_schema);
    module.attr("__version__") = foamtex::version();
    module.attr("ALGORITHM_VERSION") = foamtex::algorithm_version();
}

}  // namespace foam::texgen
