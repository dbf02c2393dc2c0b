// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/describe.h"

#include "core/foam/statistics.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/vector_files.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/preset/algorithm_version.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"

#include <algorithm>
#include <variant>

namespace foam::texgen {

namespace {

const char* description_of(LoopKind kind) {
    switch (kind) {
        case LoopKind::Breathe:
            return "a seamless loop: bubbles grow and shrink periodically";
        case LoopKind::Shear:
            return "a seamless loop: the foam is sheared to and fro";
        case LoopKind::Boil:
            return "a seamless loop: bubbles grow, shrink, vanish and are born again periodically";
        case LoopKind::Drift:
            return "a seamless loop: the foam moves by a whole number of image widths and heights";
        case LoopKind::Flow:
            return "bubbles vanish and as many new ones appear; frames at the end fade into the "
                   "states that lead to the first frame";
        case LoopKind::PingPong:
            return "the states of the foam forwards, then backwards; the first and the last state "
                   "are shown once";
        case LoopKind::None:
            break;
    }
    return "no loop";
}

ManifestLoop loop_of(const Preset& preset) {
    const LoopKind kind = preset.loop.kind;
    return {.kind = std::get<std::string>(find_key("loop.kind")->write(preset)->data),
            .description = description_of(kind),
            .period = kind == LoopKind::None ? 0 : preset.frames.count,
            .cross_faded = preset.loop.is_cross_faded(),
            .closing_error = {}};
}

ManifestConventions conventions_of(const MapOptions& maps) {
    return {
        .normal_y = maps.normal.y == NormalY::Up ? "up" : "down",
        .motion_unit = maps.motion.unit == MotionUnit::Image ? "image widths" : "pixels",
        .motion_y = maps.motion.y == MotionY::Up ? "up" : "down",
        .motion_multiplier = maps.motion.multiplier.value,
    };
}

/// Returns the hash that decides to which set of the manifest (BakedSet) a bake belongs: bakes with
/// equal hashes share a set. It covers the version of foamtex, the name of the preset, and the
/// content of the files that the keys name. It also covers all keys except image.maps, output.scene
/// and output.measurements. Because of these exceptions, bakes of different maps belong to one set.
std::string parameters_of(Preset preset) {
    preset.image.maps = Preset().image.maps;
    preset.output.scene.clear();
    preset.output.measurements.clear();
    return text_hash(FOAMTEX_VERSION "\n" + preset.name + "\n" + to_toml(preset) +
                     file_hashes(preset));
}

ManifestMap vector_map(const VectorFormat& format,
                       const std::string& part,
                       const std::vector<int>& frames) {
    return {.name = part,
            .meaning = std::string(meaning_of_part(part)),
            .unit = std::string(format.unit),
            .note = "",
            .frames = frames,
            .samples = {},
            .vector_format = std::string(format.name)};
}

std::vector<ManifestMap> maps_of(const Preset& preset, std::vector<int> frames) {
    std::ranges::sort(frames);
    std::vector<ManifestMap> maps;
    if (const VectorFormat* const format = vector_format_of(preset)) {
        for (const std::string& part : vector_parts(preset)) {
            maps.push_back(vector_map(*format, part, frames));
        }
        return maps;
    }
    for (const DrawnImage& image : drawn_images(preset)) {
        const MapTraits& traits = image.traits();
        maps.push_back({.name = std::string(traits.name),
                        .meaning = std::string(traits.meaning),
                        .unit = std::string(traits.unit),
                        .note = image.note(preset.maps),
                        .frames = frames,
                        .samples = {},
                        .packed = image.packed_channels()});
    }
    return maps;
}

FrameStatistics statistics_of(const BakedFrame& baked) {
    const Frame& frame = *baked.shown.frame;
    const FrameEffort& effort = baked.shown.effort;
    return {.frame = frame.number,
            .tiles = tiles(frame.domain),
            .time = frame.time,
            .bubbles = static_cast<int>(frame.bubbles.size() + frame.lone_bubbles.size()),
            .mean_area = mean_area(frame),
            .t1 = effort.t1,
            .t2 = effort.t2,
            .area_error = effort.area_error,
            .angle_error = effort.angle_error,
            .simulating = effort.seconds,
            .drawing = baked.seconds,
            .mechanics =
                FrameMechanics{
                    .strain = effort.strain,
                    .energy = effort.energy,
                    .stress = {effort.stress(0, 0), effort.stress(0, 1), effort.stress(1, 1)}},
            .measurements = baked.measurements};
}

ManifestFile file_of(const WrittenFile& written, int frame, const std::filesystem::path& folder) {
    ManifestFile file{.path = relative_path(written.path, folder),
                      .maps = {},
                      .frame = frame,
                      .bytes = written.bytes,
                      .pixels = written.pixels,
                      .numbers = written.numbers,
                      .displacement = written.displacement};
    for (const auto& [image, samples] : written.images) {
        file.maps.emplace_back(image.name());
    }
    if (!written.part.empty()) {
        file.maps.push_back(written.part);
    }
    return file;
}

// For each map in a written file, stores the format of the samples of the map in the set.
void store_sample_formats(BakedSet& set, const WrittenFile& written) {
    for (const auto& [image, samples] : written.images) {
        std::ranges::find(set.maps, image.name(), &ManifestMap::name)->samples = samples;
    }
}

}  // namespace

BakedSet describe(const Preset& preset, const std::vector<int>& frames) {
    return {.version = FOAMTEX_VERSION,
            .preset = preset.name,
            .description = preset.description,
            .toml = to_toml(preset),
            .parameters = parameters_of(preset),
            .seed = preset.seeding.seed,
            .width = preset.image.width,
            .height = preset.image.height,
            .frames_per_second = preset.output.frames_per_second,
            .loop = loop_of(preset),
            .conventions = conventions_of(preset.maps),
            .maps = maps_of(preset, frames),
            .files = {},
            .frame_statistics = {},
            .failure = {},
            .algorithm_version = kAlgorithmVersion};
}

void add_frame(BakedSet& set, const BakedFrame& baked, const std::filesystem::path& folder) {
    const int frame = baked.shown.frame->number;
    for (const WrittenFile& written : baked.files) {
        store_sample_formats(set, written);
        set.files.push_back(file_of(written, frame, folder));
    }
    set.frame_statistics.push_back(statistics_of(baked));
    set.loop.closing_error = baked.shown.closing_error;
}

std::string relative_path(const std::filesystem::path& path, const std::filesystem::path& folder) {
    return path.lexically_relative(folder).generic_string();
}

}  // namespace foam::texgen
