#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/file_io.h"
#include "texgen/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

/// What a PNG says about its samples.
struct PngMetadata {
    /// The samples are sRGB colours: the file carries sRGB (perceptual intent), gAMA and cHRM.
    /// Data, such as a height or an id, carries none of them, so that no reader bends the values.
    bool color = false;
    /// Keyword (1 to 79 printable ASCII characters) and UTF-8 text, in the order of the file.
    std::vector<std::pair<std::string, std::string>> text;
};

/// How each row is predicted before compression; the numbers are PNG's.
enum class PngFilter : std::uint8_t { None, Sub, Up, Average, Paeth };

/// How the samples are packed; the pixels are the same whatever it says.
struct PngEncoding {
    PngFilter filter = PngFilter::None;  // flat cells; Up for distance, height, normals
    Compression compression = Compression::Fast;
    /// 8-bit RGB and RGBA of at most 256 colours are written as numbers of colours: smaller, and
    /// decoded to the same pixels. More colours are written as they are.
    bool palette = false;
    int threads = 1;  // that compress, with Compression::Fast; the bytes are the same
};

/// A picture and what its file said about it; 8-bit samples, or 16-bit.
template <class Sample>
struct PngPicture {
    Image<Sample> pixels;
    PngMetadata metadata;
};
using PngImage = PngPicture<std::uint8_t>;
using PngImage16 = PngPicture<std::uint16_t>;

/// Samples in the depth of their file.
using PngSamples = std::variant<Image<std::uint8_t>, Image<std::uint16_t>>;

/// Encodes one picture after the other with the same buffers.
class PngEncoder {
  public:
    PngEncoder();
    ~PngEncoder();
    PngEncoder(PngEncoder&&) noexcept;
    PngEncoder& operator=(PngEncoder&&) noexcept;

    /// 1 channel is grey, 2 grey and alpha, 3 RGB, 4 RGBA (alpha not premultiplied). The rows of a
    /// view run upward, those of a PNG downward: they are turned over here and nowhere else. Valid
    /// until the next call. Throws std::invalid_argument for an empty view, another number of
    /// channels or a keyword PNG forbids.
    std::span<const std::byte> encode(ImageView<const std::uint8_t> pixels,
                                      const PngMetadata& metadata = {},
                                      const PngEncoding& encoding = {});
    std::span<const std::byte> encode(ImageView<const std::uint16_t> pixels,
                                      const PngMetadata& metadata = {},
                                      const PngEncoding& encoding = {});

  private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

/// As PngEncoder::encode, for one picture.
Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const PngMetadata& metadata = {},
                 const PngEncoding& encoding = {});
Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const PngMetadata& metadata = {},
                 const PngEncoding& encoding = {});

/// Undoes encode_png. Palettes and samples of fewer than 8 bits are widened, a transparent colour
/// becomes an alpha channel. Throws InputError for a malformed stream and for 16 bits per sample.
PngImage decode_png(std::span<const std::byte> content);

/// The same for any depth: 0 stays 0 and the largest sample becomes 65535.
PngImage16 decode_png16(std::span<const std::byte> content);

/// Whichever of the two keeps every sample as it is.
PngSamples decode_png_samples(std::span<const std::byte> content);

/// As encode_png and write_file together; throws as they do.
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const PngMetadata& metadata = {},
               const PngEncoding& encoding = {});
void write_png(const std::filesystem::path& path,
               ImageView<const std::uint16_t> pixels,
               const PngMetadata& metadata = {},
               const PngEncoding& encoding = {});

/// As read_file and the decoders together; the InputError names the file.
PngImage read_png(const std::filesystem::path& path);
PngImage16 read_png16(const std::filesystem::path& path);
PngSamples read_png_samples(const std::filesystem::path& path);

}  // namespace foam::texgen
