// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/flipbook.h"

#include "texgen/animation/progress_meter.h"
#include "texgen/image/file_io.h"
#include "texgen/sheet/earlier_sheets.h"
#include "texgen/sheet/flipbook_json.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/sheet/sheet_files.h"

#include <fmt/core.h>

#include <span>
#include <stdexcept>

namespace foam::texgen {

namespace {

std::vector<std::string> maps_of(const BakedSet& set, const FlipbookOptions& options) {
    std::vector<std::string> maps = options.maps;
    for (const ManifestMap& map : set.maps) {
        if (options.maps.empty()) {
            maps.push_back(map.name);
        }
    }
    return maps;
}

SheetLayout layout_of(const BakedSet& set, const FlipbookOptions& options, std::size_t frames) {
    if (options.strip && (options.gutter != 0 || options.columns > 1)) {
        throw std::invalid_argument("a strip must have one column and no gutter");
    }
    SheetLayout layout{.frames = static_cast<int>(frames),
                       .frame_width = set.width,
                       .frame_height = set.height,
                       .columns = options.strip ? 1 : options.columns,
                       .gutter = options.gutter};
    if (layout.columns == 0) {
        layout.columns =
            near_square_columns(layout.frames, layout.cell_width(), layout.cell_height());
    }
    check_layout(layout);
    return layout;
}

}  // namespace

Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to,
                        const ProgressCallback& on_progress) {
    const std::vector<int> frames = options.frames.empty() ? set.frames() : options.frames;
    Flipbook flipbook{{}, layout_of(set, options, frames.size()), {}};
    const std::string stem = set.preset + (options.strip ? "_strip" : "_sheet");
    std::vector<MapSequence> sequences;
    for (const std::string& map : maps_of(set, options)) {
        sequences.push_back(map_sequence(set, folder, map, frames));
    }
    ProgressMeter progress(
        Phase::Sheets, static_cast<int>(sequences.size() * frames.size()), on_progress);
    progress.begin();
    // No file gets its name before all files are complete.
    std::vector<StagedFile> staged;
    std::vector<SheetImage> images;
    for (const MapSequence& sequence : sequences) {
        const std::string name = fmt::format(
            "{}_{}{}", stem, sequence.map.name, sequence.files.front().path.extension().string());
        staged.push_back(stage_sheet(sequence, flipbook.layout, to / name, progress));
        flipbook.files.push_back(to / name);
        images.push_back({name, sequence});
    }
    flipbook.files.push_back(to / (stem + ".json"));
    Json description = flipbook_json(set, frames, flipbook.layout, images);
    flipbook.unlisted = keep_earlier_sheets(description, flipbook.files.back());
    const std::string json = indented(description);
    staged.emplace_back(flipbook.files.back(), std::as_bytes(std::span(json)));
    for (StagedFile& file : staged) {
        file.publish();
    }
    return flipbook;
}

}  // namespace foam::texgen
