// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/drawn_variations.h"

#include "core/files/scratch_folder.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/bake/estimated_memory.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/sheet/preview.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// Returns the preset of a variation, changed so that its only image is the picture of the
/// variation, which a bake writes to `folder`.
Preset picture_preset(Preset preset,
                      const VariationDrawing& drawing,
                      const std::filesystem::path& folder) {
    reduced_image(preset, drawing.side).apply_to(preset);
    preset.image.maps = {drawing.map};
    preset.output = {};
    preset.output.pattern = (folder / "{map}.######.png").string();
    return preset;
}

Image<std::uint8_t> gray_picture(int width, int height) {
    Image<std::uint8_t> picture(width, height, DisplayFrame::kColors);
    std::ranges::fill(picture.samples(), kBackgroundGray);
    return picture;
}

/// Bakes the picture of a variation in a scratch folder and reads its file. If the bake is not
/// complete, the picture is gray.
DrawnVariation draw_variation(const Preset& preset,
                              const VariationDrawing& drawing,
                              const ProgressCallback& on_progress) {
    const ScratchFolder scratch;
    const Preset small = picture_preset(preset, drawing, scratch.path());
    DrawnVariation variation{.pixels = gray_picture(small.image.width, small.image.height),
                             .outcome = {}};
    variation.outcome =
        bake_recorded(
            small, {.frames = {drawing.frame}, .threads = 1}, {.on_progress = on_progress})
            .outcome;
    if (variation.outcome.status == RunStatus::Complete) {
        const Manifest manifest = read_manifest(scratch.path());
        const MapSequence sequence = map_sequence(
            manifest.sets.front(), scratch.path(), drawing.map, std::array{drawing.frame});
        check_shown_map(drawing.map, sequence.map.samples->kind == "id");
        variation.pixels = codes_of(read_display_frame(sequence.files.front(), sequence.map));
    }
    return variation;
}

/// Throws std::invalid_argument if the pictures have different sizes.
void check_sizes(std::span<const Preset> presets, int side) {
    const ReducedImage first = reduced_image(presets.front(), side);
    for (const Preset& preset : presets) {
        const ReducedImage image = reduced_image(preset, side);
        if (image.width != first.width || image.height != first.height) {
            throw std::invalid_argument(
                fmt::format("the pictures of the variations must have the same size, but are {} x "
                            "{} and {} x {} pixels",
                            first.width,
                            first.height,
                            image.width,
                            image.height));
        }
    }
}

}  // namespace

std::uint64_t estimated_memory(std::span<const Preset> presets, const VariationDrawing& drawing) {
    std::vector<std::uint64_t> needs;  // the memory for drawing each picture
    std::uint64_t total = 0;
    for (const Preset& preset : presets) {
        const Preset small = picture_preset(preset, drawing, "");
        needs.push_back(estimated_memory(small, 1, 1));
        // The picture is kept, and copied into the sheet.
        total += std::uint64_t{2} * DisplayFrame::kColors *
                 static_cast<std::uint64_t>(small.image.width) *
                 static_cast<std::uint64_t>(small.image.height);
    }
    std::ranges::sort(needs, std::greater<>());
    const auto at_once =
        std::min(needs.size(), static_cast<std::size_t>(thread_count(drawing.threads)));
    return std::accumulate(
        needs.begin(), needs.begin() + static_cast<std::ptrdiff_t>(at_once), total);
}

std::vector<DrawnVariation> draw_variations(std::span<const Preset> presets,
                                            const VariationDrawing& drawing,
                                            const ProgressCallback& on_progress) {
    check_sizes(presets, drawing.side);
    std::vector<DrawnVariation> variations(presets.size());
    ProgressMeter meter(Phase::Previews, static_cast<int>(presets.size()), on_progress);
    meter.begin();
    parallel_for(presets.size(), 1, drawing.threads, [&](std::size_t k, std::size_t) {
        variations[k] = draw_variation(presets[k], drawing, meter.for_source());
        meter.add();
    });
    return variations;
}

}  // namespace foam::texgen
