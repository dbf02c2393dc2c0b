#pragma once

#include "texgen/image/image.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

/// Samples of one type, as their file has them: of a PNG all channels, interleaved, of an EXR one.
struct SampleBlock {
    std::string name;  // of an EXR's channel: "Y", "film.Y"; empty of a PNG
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<float>, Image<std::uint32_t>>
        samples;
};

/// An image file as it was decoded.
struct DecodedFile {
    std::vector<SampleBlock> blocks;
    std::string pixels;  // pixel_hash
};

/// Reads a .png or an .exr. Throws InputError, for a file of another name too.
DecodedFile decode_file(const std::filesystem::path& path);

/// The blocks of one map: those in the layer of its name, or all where there are no layers.
std::vector<const SampleBlock*> blocks_of(const DecodedFile& file, std::string_view map);

}  // namespace foam::texgen
