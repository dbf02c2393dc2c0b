// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/estimated_memory.h"

#include "core/parallel/parallel_for.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/vector_files.h"
#include "texgen/blocks/texel_block.h"
#include "texgen/image/format.h"
#include "texgen/preset/drawn_images.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

// A bake holds the foam and the solver's matrices, and one frame per thread that draws. The memory
// of a frame is in proportion to its pixels. If each map has a file of its own, the maps are drawn
// one after the other. The map that needs the most memory then determines the peak. If all maps
// share a file, the images of all maps are in memory at the same time. The fine random structures
// of colors and of the relief (Grain in maps/grain.h) are kept until all maps of the frame are
// drawn.

namespace foam::texgen {

namespace {

// The peak memory of drawing, encoding and writing one frame of a map, in bytes per pixel.
struct MeasuredMemory {
    std::string_view map;
    double codes;    // if the file stores codes, as a PNG does
    double numbers;  // if the file stores numbers, as an EXR does
};

// Measured with bakes of one frame of the preset sea_foam on one thread. Each number is the growth
// of the peak memory from 512 x 512 to 1024 x 1024 pixels, divided by the number of added pixels.
// The command for 512 x 512 pixels was:
//   foamtex bake sea_foam --set loop.kind=none --set frames.count=1 --set frames.warm_up=0
//     --set foam.bubbles=100 --threads 1 --size 512 --maps ... --out '{map}.png' (or '{map}.exr')
constexpr std::array<MeasuredMemory, 28> kMeasured{
    {{"albedo", 26, 38},    {"thin_film", 31, 40},  {"lit", 47, 47},
     {"opacity", 5, 9},     {"film", 22, 25},       {"distance", 14, 24},
     {"height", 14, 24},    {"normal", 37, 61},     {"normal_gl", 36, 61},
     {"normal_dx", 37, 61}, {"occlusion", 13, 23},  {"curvature", 14, 24},
     {"roughness", 30, 30}, {"pressure", 5, 10},    {"area", 7, 9},
     {"sides", 9, 13},      {"id", 9, 12},          {"id_color", 9, 19},
     {"age", 8, 9},         {"growth", 5, 10},      {"motion", 13, 32},
     {"event", 15, 25},     {"maze", 15, 26},       {"maze_solution", 19, 31},
     {"contour", 10, 23},   {"caustics", 223, 223}, {"emission", 31, 34},
     {"metallic", 30, 30}}};
// The memory of a map that is not in the table above, because it was added after the measurement.
// Also the memory of the reduced images to which automatic ranges are fitted.
constexpr MeasuredMemory kUnmeasuredMap{"", 40, 50};

// A grain for the relief has up to three floats per pixel, one for colors has one float.
constexpr double kReliefGrainBytesPerPixel = 12.0;
constexpr double kAlbedoGrainBytesPerPixel = 4.0;

constexpr double kProgramBytes = 10e6;          // bytes of the process without a foam
constexpr double kFoamBytesPerBubble = 9000.0;  // bytes of the foam and the solver per bubble
// The memory of a drawing or table and of the text of its file, in bytes per bubble.
constexpr double kVectorBytesPerBubble = 8000.0;
// The memory that a cross-fade adds to a frame, in bytes per pixel: the distance fields of two
// states of the foam, and the border between them. Measured as above, but with six frames and
// loop.kind=flow; it was 41 to 103 bytes in eight maps.
constexpr double kCrossFadeBytesPerPixel = 80.0;

// A packing keeps the images of its maps, as 4 bytes per sample, until it is drawn.
constexpr double kPackedSampleBytes = 4.0;

double map_bytes_per_pixel(std::string_view map, bool stores_codes) {
    const auto* const found = std::ranges::find(kMeasured, map, &MeasuredMemory::map);
    const MeasuredMemory& memory = found != kMeasured.end() ? *found : kUnmeasuredMap;
    return stores_codes ? memory.codes : memory.numbers;
}

double bytes_per_pixel(const DrawnImage& image, bool stores_codes) {
    double largest = 0.0;
    double kept = 0.0;
    for (const Map* const map : image.sources()) {
        largest = std::max(largest, map_bytes_per_pixel(map->name, stores_codes));
        kept += image.map() == nullptr ? kPackedSampleBytes * channel_count(*map) : 0.0;
    }
    return largest + kept;
}

// Returns the memory, in bytes, for each sample of a file that stores all maps: 4 for the sample as
// a float, and 2 or 4 for its copy in the type of the file. Colors count like numbers, although the
// file always stores them as half floats.
double bytes_per_layer_sample(SampleType numbers) {
    return numbers == SampleType::Half ? 6.0 : 8.0;
}

// Returns the number of copies of a sheet that are in memory when it is written: its samples and
// the content of its file. The compression of a KTX2 file needs a third copy.
double copies_of_sheet(SheetKind sheets) {
    return sheets == SheetKind::Ktx2 ? 3.0 : 2.0;
}

// Returns the bytes per pixel of an image in an array texture with mip levels, as texture_of
// compresses it (image/gpu_texture.h).
double array_bytes_per_pixel(const MapTraits& traits, const ImageOptions& size) {
    constexpr double kMipLevels = 4.0 / 3.0;
    const int channels = channel_count(traits);
    const int stored = channels == 3 ? 4 : channels;
    if (traits.png_bits > 8) {
        return kMipLevels * 2 * stored;
    }
    if (traits.kind == MapKind::Id || !has_whole_blocks(size.width, size.height)) {
        return kMipLevels * stored;
    }
    return kMipLevels * (channels == 1 ? 0.5 : 1.0);
}

// Returns the memory, in bytes per pixel of a frame, that the sheet of an image takes while it is
// composed and written.
double sheet_bytes_per_pixel(const MapTraits& traits, const Preset& preset, bool stores_codes) {
    const SheetKind sheets = preset.output.sheets;
    if (sheets == SheetKind::Dds || sheets == SheetKind::Ktx2) {
        return copies_of_sheet(sheets) * array_bytes_per_pixel(traits, preset.image);
    }
    const double bytes = stores_codes ? traits.png_bits / 8.0 : 4.0;
    return copies_of_sheet(sheets) * channel_count(traits) * bytes;
}

// Returns the memory, in bytes, of the largest sheet of a bake (output.sheets). At its end, the
// bake joins its frames into the sheets of all images, one sheet after the other. `pixels` is the
// number of pixels of all frames together.
double sheet_memory(const Preset& preset, double pixels, bool stores_codes) {
    double largest = 0.0;
    for (const DrawnImage& image : drawn_images(preset)) {
        largest = std::max(largest, sheet_bytes_per_pixel(image.traits(), preset, stores_codes));
    }
    return preset.output.sheets == SheetKind::None ? 0.0 : pixels * largest;
}

// Returns the memory, in bytes, that a vector file takes while it is drawn and encoded.
double vector_memory(const Preset& preset) {
    const VectorFormat& format = *vector_format_of(preset);
    return format.estimate != nullptr
               ? format.estimate(vector_settings(preset), preset.seeding.bubbles).memory_bytes
               : kVectorBytesPerBubble * preset.seeding.bubbles;
}

// Returns the memory, in bytes per pixel, of the grains that the maps of a preset draw.
double grain_bytes_per_pixel(const Preset& preset) {
    const std::vector<const Map*> maps = source_maps(preset);
    const auto grain = [&](double strength, std::string_view table, double bytes) {
        const auto uses = [&](const Map* map) { return uses_table(*map, table); };
        return strength > 0.0 && std::ranges::any_of(maps, uses) ? bytes : 0.0;
    };
    return grain(preset.maps.albedo.grain, "albedo", kAlbedoGrainBytesPerPixel) +
           grain(preset.maps.relief.grain, "relief", kReliefGrainBytesPerPixel);
}

}  // namespace

std::uint64_t estimated_foam_memory(std::size_t bubbles) {
    return static_cast<std::uint64_t>(kProgramBytes +
                                      kFoamBytesPerBubble * static_cast<double>(bubbles));
}

std::uint64_t estimated_foam_memory(const Preset& preset) {
    return estimated_foam_memory(static_cast<std::size_t>(preset.seeding.bubbles));
}

std::uint64_t estimated_cache_memory(const Preset& preset, std::size_t frames, int threads) {
    const auto drawn = std::min(frames, static_cast<std::size_t>(thread_count(threads)));
    const double pixels = static_cast<double>(drawn) * kMeasuredSide * kMeasuredSide;
    return estimated_foam_memory(preset) +
           static_cast<std::uint64_t>(pixels * kUnmeasuredMap.codes);
}

std::uint64_t estimated_memory(const Preset& preset, std::size_t frames, int threads) {
    const FilePattern pattern(preset);
    if (pattern.is_vector()) {
        const auto drawn = std::min(frames, static_cast<std::size_t>(thread_count(threads)));
        return estimated_foam_memory(preset) +
               static_cast<std::uint64_t>(static_cast<double>(drawn) * vector_memory(preset));
    }
    const bool stores_codes = pattern.format().samples == FormatSamples::Codes;
    double largest = 0.0;
    double shared = 0.0;
    for (const DrawnImage& image : drawn_images(preset)) {
        largest = std::max(largest, bytes_per_pixel(image, stores_codes));
        shared += channel_count(image.traits()) * bytes_per_layer_sample(preset.output.exr_numbers);
    }
    const double per_pixel = largest + grain_bytes_per_pixel(preset) +
                             (pattern.stores_all_maps_in_one_file() ? shared : 0.0) +
                             (preset.loop.is_cross_faded() ? kCrossFadeBytesPerPixel : 0.0);
    const double pixels = static_cast<double>(preset.image.width) * preset.image.height;
    const auto drawn =
        static_cast<double>(std::min(frames, static_cast<std::size_t>(thread_count(threads))));
    // The memory of drawing is added to the memory of the sheets, because it is not returned to the
    // system before the sheets are made.
    return estimated_foam_memory(preset) +
           static_cast<std::uint64_t>(
               drawn * pixels * per_pixel +
               sheet_memory(preset, static_cast<double>(frames) * pixels, stores_codes));
}

}  // namespace foam::texgen
