// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/array_files.h"

#include "core/parallel/parallel_for.h"
#include "texgen/image/format.h"
#include "texgen/image/texture_file.h"
#include "texgen/maps/all_maps.h"
#include "texgen/sheet/map_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the meaning of the samples of a map. The map may have been baked by another version of
// foamtex and be unknown to this version. If an unknown map does not consist of ids, its samples
// count as Numbers.
TexelMeaning meaning_of(const ManifestMap& map) {
    if (map.samples && map.samples->kind == "id") {
        return TexelMeaning::Ids;
    }
    const auto maps = all_maps();
    const auto known = std::ranges::find(maps, map.name, &Map::name);
    const bool is_normal = known != maps.end() && known->mixing == Mixing::Slopes;
    return is_normal ? TexelMeaning::Normals : TexelMeaning::Numbers;
}

GpuEncoding encoding_of(const ManifestMap& map) {
    // For example "X Y 0": PNG files have a third channel, which is 0 everywhere.
    const bool is_padded = map.samples && map.samples->channels.ends_with(" 0");
    return {.meaning = meaning_of(map), .used_channels = is_padded ? 2 : 0};
}

// Reads a file that contains a texture of one layer.
GpuTexture read_texture(const TextureFormat& format, const std::filesystem::path& path) {
    return decode_file(path, [&](std::span<const std::byte> content) {
        GpuTexture texture = format.decode(content);
        if (texture.layers.size() != 1) {
            throw InputError(fmt::format("the file is an array of {} layers, not a single image",
                                         texture.layers.size()));
        }
        return texture;
    });
}

GpuTexture texture_in(const MapFile& file, const ManifestMap& map) {
    if (const TextureFormat* const format = find_texture_format(file.path.string())) {
        return read_texture(*format, file.path);
    }
    const Picture picture = read_map_frame(file, map.name);
    const ChannelGroup& group = picture.groups.front();
    if (!group.has_codes()) {
        throw InputError(
            fmt::format("'{}' stores samples of the type {}, but an array needs integers of 8 or "
                        "16 bits; bake PNG files",
                        file.path.string(),
                        name_of(group.type)));
    }
    return texture_of(picture, encoding_of(map));
}

// Throws InputError if a frame and the first frame of the array differ in pixel format, size or
// number of mip levels.
void check_same(const GpuTexture& frame, const GpuTexture& array, const MapFile& file) {
    if (frame.format != array.format || frame.width != array.width ||
        frame.height != array.height || frame.levels() != array.levels()) {
        throw InputError(fmt::format(
            "'{}' is a texture of {} x {} in {} with {} mip levels, but the first frame "
            "is one of {} x {} in {} with {}",
            file.path.string(),
            frame.width,
            frame.height,
            facts_of(frame.format).name,
            frame.levels(),
            array.width,
            array.height,
            facts_of(array.format).name,
            array.levels()));
    }
}

}  // namespace

StagedArray stage_array(const MapSequence& sequence,
                        const TextureAnimation& animation,
                        const std::filesystem::path& path,
                        ProgressMeter& progress) {
    make_folders(path.parent_path());
    GpuTexture array = texture_in(sequence.files.front(), sequence.map);
    array.is_array = true;
    array.animation = animation;
    array.layers.resize(sequence.files.size());
    std::vector<char> opaque(sequence.files.size(), array.opaque ? 1 : 0);
    parallel_for(static_cast<int>(sequence.files.size()) - 1, 0, [&](int k) {
        const auto layer = static_cast<std::size_t>(k) + 1;
        GpuTexture frame = texture_in(sequence.files[layer], sequence.map);
        check_same(frame, array, sequence.files[layer]);
        opaque[layer] = frame.opaque ? 1 : 0;
        array.layers[layer] = std::move(frame.layers.front());
        progress.add();
    });
    array.opaque = std::ranges::all_of(opaque, [](char is_opaque) { return is_opaque != 0; });
    StagedArray staged{StagedFile(path, find_texture_format(path.string())->encode(array)),
                       array.format,
                       array.levels()};
    progress.add();
    return staged;
}

}  // namespace foam::texgen
