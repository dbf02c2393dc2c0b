// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/vector_files.h"

#include "texgen/preset/drawn_images.h"

#include <fmt/core.h>

#include <stdexcept>

namespace foam::texgen {

namespace {

[[noreturn]] void reject(const VectorFormat& format, const char* reason) {
    throw std::invalid_argument(fmt::format("{} files {}", format.name, reason));
}

constexpr const char* kNoCrossFade =
    "cannot show the frames of the loop \"flow\", which fade from one foam into another; set "
    "loop.kind to another loop, or to \"none\"";

VectorSource source_of(FrameLayers& layers, const SimulatedFrame& shown, const Preset& preset) {
    const bool has_texts = preset.output.texts == FileTexts::Written;
    return {layers,
            vector_settings(preset),
            fmt::format("{}, frame {}", preset.name, shown.frame->number),
            has_texts ? fmt::format("{} (foamtex " FOAMTEX_VERSION ", seed {})",
                                    preset.description,
                                    preset.seeding.seed)
                      : ""};
}

}  // namespace

VectorSettings vector_settings(const Preset& preset) {
    return {preset.maps,
            preset.vector,
            preset.mesh,
            preset.image.maps,
            preset.image.width,
            preset.image.height};
}

const VectorFormat* vector_format_of(const Preset& preset) {
    return find_vector_format(preset.output.pattern);
}

std::vector<std::string> vector_parts(const Preset& preset) {
    return vector_format_of(preset)->parts(vector_settings(preset));
}

std::vector<std::string> file_words(const Preset& preset) {
    if (vector_format_of(preset) != nullptr) {
        return vector_parts(preset);
    }
    std::vector<std::string> words;
    for (const DrawnImage& image : drawn_images(preset)) {
        words.push_back(file_word(preset, image.name()));
    }
    return words;
}

void check_vector_files(const Preset& preset) {
    const VectorFormat* const format = vector_format_of(preset);
    if (format == nullptr) {
        return;
    }
    if (!preset.output.pack.empty()) {
        reject(*format, "have no channels, so output.pack (--pack) must be empty");
    }
    if (preset.output.sheets != SheetKind::None) {
        reject(*format, "have no pixels, so output.sheets must be \"none\"");
    }
    if (preset.loop.is_cross_faded()) {
        reject(*format, kNoCrossFade);
    }
    format->check(vector_settings(preset));
}

std::string encode_vector(const VectorFormat& format,
                          const SimulatedFrame& shown,
                          const Preset& preset,
                          std::string_view part) {
    if (shown.fading_in.frame) {
        reject(format, kNoCrossFade);
    }
    const RasterGrid grid{preset.image.width, preset.image.height, 0, 0, shown.view};
    FrameLayers layers(shown.input({}), grid, 1);
    return format.encode(source_of(layers, shown, preset), part);
}

std::string to_svg(const SimulatedFrame& shown, const Preset& preset) {
    const VectorFormat& svg = *find_vector_format(".svg");
    return encode_vector(svg, shown, preset, svg.parts(vector_settings(preset)).front());
}

}  // namespace foam::texgen
