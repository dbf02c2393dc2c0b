#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/frame_rate.h"
#include "texgen/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

/// How samples are stored: numbers in 16 bits (up to 65504, 11 bits of precision) or 32, or
/// integers.
enum class ExrType { Half, Float, Uint };

/// One channel of a file. Borrows its samples: floats for Half and Float, integers for Uint.
struct ExrChannel {
    std::string name;  // "Y" of grey, "R" ...; "height.Y" lies in the layer "height"
    ExrType type = ExrType::Half;
    std::variant<ImageView<const float>, ImageView<const std::uint32_t>> pixels;
    int channel = 0;  // of the view
};

/// What an EXR says about its samples.
struct ExrMetadata {
    /// Colours are light with the primaries and the white of sRGB (`chromaticities`).
    bool color = false;
    bool periodic = false;                     // tiles in both directions (`wrapmodes`)
    std::optional<FrameRate> frame_rate = {};  // `framesPerSecond`
    /// String attributes: names of 1 to 31 characters that EXR does not give a meaning of its own,
    /// and UTF-8 text. They are read in alphabetical order.
    std::vector<std::pair<std::string, std::string>> text = {};
};

/// All of these keep every bit: Zips packs single rows, Zip 16 and Piz 32 at a time.
enum class ExrCompression { None, Rle, Zips, Zip, Piz };

/// How the samples are packed; the pixels are the same whatever it says.
struct ExrEncoding {
    ExrCompression compression = ExrCompression::Zip;
    int zip_level = 2;  // of Zip and Zips: 1 is fast, 9 small
    /// Tiles of 64 x 64 in mip levels, each half as wide and high as the one before, rounded down,
    /// to 1 x 1. Numbers are means by area, integers are chosen, never mixed.
    bool mip_levels = false;
    int threads = 1;  // that compress; the bytes are the same
};

/// Samples as they are, nothing held at 0 or 1. Channels may come in any order, are all of one
/// size, and have different names. By convention colours are multiplied by their opacity, A.
/// Throws std::invalid_argument for channels or texts that break these rules, and for a number that
/// is not finite or that Half cannot hold; OutputError where the library gives up.
Bytes encode_exr(std::span<const ExrChannel> channels,
                 const ExrMetadata& metadata = {},
                 const ExrEncoding& encoding = {});

/// As encode_exr and write_file together; throws as they do.
void write_exr(const std::filesystem::path& path,
               std::span<const ExrChannel> channels,
               const ExrMetadata& metadata = {},
               const ExrEncoding& encoding = {});

/// A channel that was read: floats of Half and Float.
struct ExrPlane {
    std::string name;
    ExrType type = ExrType::Half;
    std::variant<Image<float>, Image<std::uint32_t>> pixels;
};

/// What a file holds: channels of one size, in the order of their names.
struct ExrImage {
    std::vector<ExrPlane> channels;
    ExrMetadata metadata;
};

/// Reads a file of rows or tiles; of a mip-mapped one the level asked for. Throws InputError for a
/// malformed stream, a level that is not there, several parts, deep or subsampled channels.
ExrImage decode_exr(std::span<const std::byte> content, int level = 0);

/// As read_file and decode_exr together; the InputError names the file.
ExrImage read_exr(const std::filesystem::path& path, int level = 0);

}  // namespace foam::texgen
