// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/downloads.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "core/files/scratch_folder.h"
#include "texgen/bake/bake.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/image/apng.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

/// Returns a file name for a quoted text in an HTTP header: quotation marks, backslashes and
/// control characters are replaced by '_'.
std::string header_word(std::string name) {
    std::ranges::replace_if(
        name,
        [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; },
        '_');
    return name;
}

HttpResponse attachment(std::span<const std::byte> content,
                        const std::string& name,
                        const std::string& type) {
    return {.content_type = type,
            .headers = {{"Content-Disposition",
                         fmt::format("attachment; filename=\"{}\"", header_word(name))}},
            .body = std::string(as_text(content))};
}

/// Bakes frames of one map into a scratch folder, as PNGs or SVGs, and returns the contents of
/// their files, in the order of the frames. Throws SimulationFailed if a frame cannot be simulated.
std::vector<Bytes> baked_frames(Preset preset,
                                const std::string& map,
                                const std::vector<int>& frames,
                                const FrameSource& source,
                                std::string_view suffix) {
    const ScratchFolder scratch;
    preset.image.maps = {map};
    preset.output.pack.clear();
    preset.output.names.clear();
    preset.output.pattern = (scratch.path() / fmt::format("frame.######{}", suffix)).string();
    preset.output.primaries = Primaries::Srgb;
    preset.output.sheets = SheetKind::None;
    const BakeSummary summary = bake(preset, {.frames = frames, .source = source});
    if (const std::string failure = failure_of(summary.outcome); !failure.empty()) {
        throw SimulationFailed(failure);
    }
    std::vector<Bytes> files;
    for (const std::filesystem::path& path : summary.files) {
        files.push_back(read_file(path, kImageInput));
    }
    return files;
}

}  // namespace

HttpResponse preset_download(const PageSettings& settings, const PagePreset& loaded) {
    const std::string toml = preset_file(settings, loaded);
    return attachment(
        std::as_bytes(std::span(toml)), loaded.preset.name + ".toml", "application/toml");
}

HttpResponse frame_download(const Preset& preset,
                            const std::string& map,
                            int frame,
                            FrameStore& store) {
    const std::vector<Bytes> files =
        baked_frames(preset, map, {frame}, store.source(preset), ".png");
    return attachment(
        files.at(0), fmt::format("{}_{}.{:04}.png", preset.name, map, frame), "image/png");
}

HttpResponse drawing_download(const Preset& preset,
                              const std::string& map,
                              int frame,
                              FrameStore& store) {
    const std::vector<Bytes> files =
        baked_frames(preset, map, {frame}, store.source(preset), ".svg");
    return attachment(
        files.at(0), fmt::format("{}.{:04}.svg", preset.name, frame), "image/svg+xml");
}

HttpResponse loop_download(Preset preset,
                           const std::string& map,
                           std::optional<int> side,
                           FrameStore& store) {
    const FrameSource source = store.source(preset);
    if (side) {
        reduced_image(preset, *side).apply_to(preset);
    }
    const std::vector<int> frames = frames_to(preset.frames.count);
    ApngMuxer muxer(preset.frames.count, {preset.output.frames_per_second, 1});
    for (const Bytes& file : baked_frames(preset, map, frames, source, ".png")) {
        muxer.add(file);
    }
    return attachment(muxer.finish(), fmt::format("{}_{}_loop.png", preset.name, map), "image/png");
}

}  // namespace foam::texgen
