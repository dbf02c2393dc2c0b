#include "texgen/image/exr.h"
#include "texgen/sheet/exr_frame.h"
#include "texgen/sheet/sheet_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace foam::texgen {

namespace {

/// A plane of the same kind for the whole sheet, blank.
ExrPlane sheet_plane(const ExrPlane& plane, const SheetLayout& layout) {
    return std::visit(
        [&]<class Sample>(const Image<Sample>& /*pixels*/) {
            return ExrPlane{
                plane.name,
                plane.type,
                Image<Sample>(
                    static_cast<int>(layout.width()), static_cast<int>(layout.height()), 1)};
        },
        plane.pixels);
}

bool same_channels(const std::vector<ExrPlane>& planes, const std::vector<ExrPlane>& others) {
    return std::ranges::equal(planes, others, [](const ExrPlane& a, const ExrPlane& b) {
        return a.name == b.name && a.type == b.type;
    });
}

void place_plane(ExrPlane& sheet,
                 const SheetLayout& layout,
                 int number,
                 const ExrPlane& plane,
                 const MapFile& file) {
    std::visit(
        [&]<class Sample>(const Image<Sample>& frame) {
            check_extents(file, layout, frame.width(), frame.height());
            place_frame(std::get<Image<Sample>>(sheet.pixels).view(),
                        layout,
                        number,
                        frame.view(),
                        gutter_of(file));
        },
        plane.pixels);
}

std::vector<ExrChannel> channels_of(const std::vector<ExrPlane>& planes) {
    std::vector<ExrChannel> channels;
    for (const ExrPlane& plane : planes) {
        std::visit(
            [&](const auto& pixels) {
                channels.push_back({plane.name, plane.type, pixels.view()});
            },
            plane.pixels);
    }
    return channels;
}

/// Of the first frame, but that a sheet does not tile.
ExrMetadata metadata_of(ExrMetadata metadata, const SheetLayout& layout) {
    metadata.periodic = false;
    if (!metadata.text.empty()) {
        metadata.text.emplace_back("Flipbook", text_of(layout));
    }
    return metadata;
}

}  // namespace

void write_exr_sheet(const MapSequence& sequence,
                     const SheetLayout& layout,
                     const std::filesystem::path& path) {
    std::vector<ExrPlane> sheet;
    ExrMetadata metadata;
    for (int k = 0; k < layout.frames; ++k) {
        const MapFile& file = sequence.files[static_cast<std::size_t>(k)];
        const ExrImage frame = read_exr_frame(file, sequence.map.name);
        if (k == 0) {
            metadata = metadata_of(frame.metadata, layout);
            for (const ExrPlane& plane : frame.channels) {
                sheet.push_back(sheet_plane(plane, layout));
            }
        }
        if (!same_channels(frame.channels, sheet)) {
            throw InputError(
                fmt::format("'{}' has other channels than the first frame", file.path.string()));
        }
        for (std::size_t c = 0; c < sheet.size(); ++c) {
            place_plane(sheet[c], layout, k, frame.channels[c], file);
        }
    }
    write_exr(path, channels_of(sheet), metadata, {.threads = 0});
}

}  // namespace foam::texgen
