// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/estimated_size.h"

#include "core/files/file_io.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/vector_files.h"
#include "texgen/blocks/texel_block.h"
#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/drawn_images.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <string>
#include <string_view>

namespace foam::texgen {

namespace {

// The size of a drawing or table in bytes per bubble. SVG files have about 1,000 bytes per bubble;
// files of other formats have fewer.
constexpr double kVectorFileBytes = 1000.0;

// The size of a file of one map, in bytes per pixel, as a PNG and as an EXR.
struct MeasuredSize {
    std::string_view map;
    double png;
    double exr;
};

// The sizes are means over three images, frame 1 of each of the presets sea_foam, potion and lava.
// The images have 1024 x 1024 pixels; their files have the default compression and do not contain
// the texts that name the program, preset and seed. The command was:
//   foamtex bake PRESET --set loop.kind=none --set frames.count=1 --set frames.warm_up=0
//     --set output.texts=left-out --maps ... --out '{map}.png' (or '{map}.exr')
// The sizes of most maps varied by less than 20 % between the presets.
constexpr std::array<MeasuredSize, 13> kVaried{{{"albedo", 1.0, 2.3},
                                                {"thin_film", 1.4, 3.1},
                                                {"lit", 1.0, 2.7},
                                                {"distance", 1.0, 3.9},
                                                {"height", 1.6, 3.6},
                                                {"normal", 1.0, 10.6},
                                                {"normal_gl", 1.0, 10.6},
                                                {"normal_dx", 1.0, 10.6},
                                                {"occlusion", 0.32, 3.7},
                                                {"curvature", 1.5, 3.8},
                                                {"motion", 2.6, 7.7},
                                                {"caustics", 1.1, 2.9},
                                                {"emission", 0.8, 2.8}}};

// All other maps consist of large areas of one value. In the same measurement, the files of these
// maps had on average 0.1 (PNG) and 0.3 (EXR) bytes per pixel. The files of `maze` were the
// largest: 0.26 and 0.68 bytes per pixel. The numbers below are a little above the averages.
constexpr MeasuredSize kFlat{"", 0.15, 0.35};

// The number of pixels of all mip levels of an image, divided by the number of its own pixels.
constexpr double kMipLevels = 4.0 / 3.0;

// Returns the size that the file of a map has without compression, in bytes per pixel.
// `stores_codes` is true for formats with integer samples, such as PNG. In other formats, such as
// EXR, each channel counts as a float of 4 bytes.
double raw_bytes_per_pixel(const MapTraits& map, bool stores_codes) {
    return channel_count(map) * (stores_codes ? map.png_bits / 8.0 : 4.0);
}

// Returns the bytes per pixel of a texture for graphics hardware (DDS or KTX2; no other formats
// have ImageFormat::is_lossy). If output.mip_levels is true, the bytes of all mip levels are
// included.
double texture_bytes_per_pixel(const MapTraits& map, const Preset& preset) {
    const OutputOptions& output = preset.output;
    const bool is_compressed = output.block_compression == BlockCompression::Auto &&
                               has_whole_blocks(preset.image.width, preset.image.height) &&
                               map.png_bits == 8 && map.kind != MapKind::Id;
    const int channels = channel_count(map);
    const double bytes = is_compressed ? (channels == 1 ? 0.5 : 1.0)
                                       : (channels == 3 ? 4 : channels) * map.png_bits / 8.0;
    return bytes * (output.mip_levels ? kMipLevels : 1.0);
}

double map_bytes_per_pixel(const MapTraits& map, const Preset& preset) {
    const OutputOptions& output = preset.output;
    if (FilePattern(preset).format().is_lossy) {
        return texture_bytes_per_pixel(map, preset);
    }
    const bool stores_codes = FilePattern(preset).format().samples == FormatSamples::Codes;
    const double levels =
        !stores_codes && output.exr_layout == ExrLayout::MipLevels ? kMipLevels : 1.0;
    const bool is_raw = stores_codes ? output.png_compression == Compression::None
                                     : output.exr_compression == ExrCompression::None;
    if (is_raw) {
        return levels * raw_bytes_per_pixel(map, stores_codes);
    }
    const auto* const found = std::ranges::find(kVaried, map.name, &MeasuredSize::map);
    const MeasuredSize& size = found != kVaried.end() ? *found : kFlat;
    return levels * (stores_codes ? size.png : size.exr);
}

// Returns the size of the file of an image in bytes per pixel: the sum over the maps from which the
// image is drawn. The sum is only approximate for a packing, which stores channels of several maps.
double bytes_per_pixel(const DrawnImage& image, const Preset& preset) {
    double bytes = 0.0;
    for (const Map* const map : image.sources()) {
        bytes += map_bytes_per_pixel(drawn_traits(*map, preset.maps), preset);
    }
    return bytes;
}

double vector_file_bytes(const Preset& preset) {
    const VectorFormat& format = *vector_format_of(preset);
    return format.estimate != nullptr
               ? format.estimate(vector_settings(preset), preset.seeding.bubbles).file_bytes
               : kVectorFileBytes * preset.seeding.bubbles;
}

// Returns the sizes of the files of a frame.
std::vector<std::uint64_t> file_sizes(const Preset& preset) {
    const FilePattern pattern(preset);
    if (pattern.is_vector()) {
        return std::vector<std::uint64_t>(file_words(preset).size(),
                                          static_cast<std::uint64_t>(vector_file_bytes(preset)));
    }
    const double pixels = static_cast<double>(preset.image.width) * preset.image.height;
    std::vector<std::uint64_t> sizes;
    for (const DrawnImage& image : drawn_images(preset)) {
        sizes.push_back(static_cast<std::uint64_t>(pixels * bytes_per_pixel(image, preset)));
    }
    if (pattern.stores_all_maps_in_one_file()) {
        sizes = {std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0})};
    }
    return sizes;
}

}  // namespace

std::uint64_t estimated_size(const Preset& preset, const std::vector<int>& frames) {
    const FrameFiles files(preset);
    const std::vector<std::uint64_t> sizes = file_sizes(preset);
    std::uint64_t sum = 0;
    for (const int frame : frames) {
        const std::vector<std::filesystem::path> paths = files.paths(frame);
        for (std::size_t k = 0; k < paths.size(); ++k) {
            sum += is_existing(paths[k]) ? 0 : sizes[k];
        }
    }
    return sum;
}

}  // namespace foam::texgen
