// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/sheet_files.h"

#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"
#include "texgen/sheet/map_frame.h"
#include "texgen/sheet/place_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

std::string text_of(const SheetLayout& layout) {
    return fmt::format("{} x {} frames of {} x {}, gutter {}",
                       layout.columns,
                       layout.rows(),
                       layout.frame_width,
                       layout.frame_height,
                       layout.gutter);
}

// Returns a sheet of zeros with the channels and the metadata of a frame.
Picture blank_sheet(const Picture& frame, const SheetLayout& layout) {
    Picture sheet{{}, frame.metadata};
    sheet.metadata.periodic = false;
    if (!sheet.metadata.text.empty()) {
        sheet.metadata.text.emplace_back("Flipbook", text_of(layout));
    }
    const auto width = static_cast<int>(layout.width());
    const auto height = static_cast<int>(layout.height());
    for (const ChannelGroup& group : frame.groups) {
        std::visit(
            [&]<class Sample>(const Image<Sample>& image) {
                sheet.groups.push_back(
                    {group.names, group.type, Image<Sample>(width, height, image.channels())});
            },
            group.samples);
    }
    return sheet;
}

// Returns the names and sample types of all channels, for example "R G B (half), Y (float)".
std::string channel_list(const Picture& picture) {
    std::string list;
    for (const ChannelGroup& group : picture.groups) {
        list += list.empty() ? "" : ", ";
        for (const std::string& name : group.names) {
            list += name + ' ';
        }
        list += fmt::format("({})", name_of(group.type));
    }
    return list;
}

// Throws InputError if a frame has other channels than the sheet, or another size than the layout
// gives for frames.
void check_frame(const Picture& frame,
                 const Picture& sheet,
                 const SheetLayout& layout,
                 const std::filesystem::path& path) {
    const bool same_channels = std::ranges::equal(
        frame.groups, sheet.groups, [](const ChannelGroup& a, const ChannelGroup& b) {
            return a.names == b.names && a.type == b.type;
        });
    if (!same_channels) {
        throw InputError(fmt::format("'{}' has the channels {}, but the first frame has {}",
                                     path.string(),
                                     channel_list(frame),
                                     channel_list(sheet)));
    }
    if (frame.width() != layout.frame_width || frame.height() != layout.frame_height) {
        throw InputError(fmt::format("'{}' is {} x {} pixels, but the manifest says {} x {}",
                                     path.string(),
                                     frame.width(),
                                     frame.height(),
                                     layout.frame_width,
                                     layout.frame_height));
    }
}

void place_group(ChannelGroup& sheet,
                 const SheetLayout& layout,
                 int number,
                 const ChannelGroup& group,
                 Gutter gutter) {
    std::visit(
        [&]<class Sample>(const Image<Sample>& frame) {
            place_frame(std::get<Image<Sample>>(sheet.samples).view(),
                        layout,
                        number,
                        frame.view(),
                        gutter);
        },
        group.samples);
}

Picture sheet_of(const MapSequence& sequence, const SheetLayout& layout, ProgressMeter& progress) {
    Picture sheet;
    for (int k = 0; k < layout.frames; ++k) {
        if (k > 0) {
            progress.add();
        }
        const MapFile& file = sequence.files[static_cast<std::size_t>(k)];
        const Picture frame = read_map_frame(file, sequence.map.name);
        if (k == 0) {
            sheet = blank_sheet(frame, layout);
        }
        check_frame(frame, sheet, layout, file.path);
        const Gutter gutter = file.tiles ? Gutter::Periodic : Gutter::Edge;
        for (std::size_t c = 0; c < sheet.groups.size(); ++c) {
            place_group(sheet.groups[c], layout, k, frame.groups[c], gutter);
        }
    }
    return sheet;
}

// Returns the encoding options for a map. Other versions of foamtex may have baked a map that this
// version does not have; for such a map, no PNG filter is used.
EncodingOptions encoding_of(std::string_view map) {
    const auto maps = all_maps();
    const auto known = std::ranges::find(maps, map, &Map::name);
    const PngFilter filter = known != maps.end() ? known->png_filter : PngFilter::None;
    return {.png = {.filter = filter, .threads = 0}, .exr = {.threads = 0}};
}

Bytes encoded(const Picture& sheet, std::string_view map, const std::filesystem::path& path) {
    const ImageFormat* const format = find_format(path.string());
    assert(format != nullptr);
    try {
        return format->encode(sheet, encoding_of(map));
    } catch (const OutputError& error) {
        throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
}

}  // namespace

StagedFile stage_sheet(const MapSequence& sequence,
                       const SheetLayout& layout,
                       const std::filesystem::path& path,
                       ProgressMeter& progress) {
    check_layout(layout);
    make_folders(path.parent_path());
    StagedFile sheet(path, encoded(sheet_of(sequence, layout, progress), sequence.map.name, path));
    progress.add();
    return sheet;
}

}  // namespace foam::texgen
