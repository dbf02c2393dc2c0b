#include "texgen/image/png.h"
#include "texgen/maps/map.h"
#include "texgen/sheet/sheet_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace foam::texgen {

namespace {

PngPicture<std::uint8_t> read_picture(const std::filesystem::path& path, std::uint8_t /*kind*/) {
    return read_png(path);
}

PngPicture<std::uint16_t> read_picture(const std::filesystem::path& path, std::uint16_t /*kind*/) {
    return read_png16(path);
}

void check_channels(const MapFile& file, int channels, int wanted) {
    if (channels != wanted) {
        throw InputError(fmt::format("'{}' has {} channels, not {} as the first frame",
                                     file.path.string(),
                                     channels,
                                     wanted));
    }
}

/// What suits the map; files of another version may show one that is not known here.
PngEncoding encoding_of(std::string_view map) {
    const auto maps = all_maps();
    const auto known = std::ranges::find(maps, map, &Map::name);
    return {.filter = known != maps.end() ? known->png_filter : PngFilter::None, .threads = 0};
}

template <class Sample>
void write_sheet_of(const MapSequence& sequence,
                    const SheetLayout& layout,
                    const std::filesystem::path& path) {
    Image<Sample> sheet;
    PngMetadata metadata;
    for (int k = 0; k < layout.frames; ++k) {
        const MapFile& file = sequence.files[static_cast<std::size_t>(k)];
        const PngPicture<Sample> frame = read_picture(file.path, Sample{});
        check_extents(file, layout, frame.pixels.width(), frame.pixels.height());
        if (k == 0) {
            metadata = frame.metadata;
            sheet = Image<Sample>(static_cast<int>(layout.width()),
                                  static_cast<int>(layout.height()),
                                  frame.pixels.channels());
        }
        check_channels(file, frame.pixels.channels(), sheet.channels());
        place_frame(sheet.view(), layout, k, frame.pixels.view(), gutter_of(file));
    }
    if (!metadata.text.empty()) {
        metadata.text.emplace_back("Flipbook", text_of(layout));
    }
    write_png(path, std::as_const(sheet).view(), metadata, encoding_of(sequence.map.name));
}

}  // namespace

void write_png_sheet(const MapSequence& sequence,
                     const SheetLayout& layout,
                     const std::filesystem::path& path) {
    if (sequence.map.samples->type == "uint16") {
        write_sheet_of<std::uint16_t>(sequence, layout, path);
    } else {
        write_sheet_of<std::uint8_t>(sequence, layout, path);
    }
}

}  // namespace foam::texgen
