// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

struct ImageFormat;
struct Preset;
struct VectorFormat;

/// Names the files of a bake. A pattern may contain these placeholders:
///
///     {map}             the word of the map or packing (file_word), or what a vector file shows
///     {preset} {seed}   the name and the seed of the preset
///     #                 the frame number in four digits
///     ## ###            the frame number in as many digits as there are characters
///     @ @@              the frame number in as many digits as there are characters
///     %04d %d           the frame number as in C's printf, with a width of at most 9
///
/// {size} and the keys of the preset, such as {foam.bubbles}, are also placeholders
/// (placeholder_text in preset/placeholder.h). Frame numbers with fewer digits get leading zeros;
/// longer numbers are written in full.
///
/// If the pattern of a format with several tables (CSV) has no {map}, "_{map}" is inserted before
/// the first period of the file name. Periods in braces, and a period with which the file name
/// begins, do not count.
class FilePattern {
  public:
    /// Parses the pattern of a preset, output.pattern, and replaces the placeholders of the preset
    /// by its values. Throws std::invalid_argument if a placeholder is unknown or malformed, or if
    /// its value cannot be a part of a file name. Also throws it if the pattern does not end in the
    /// suffix of an image format or of a vector format.
    explicit FilePattern(const Preset& preset);

    /// Parses the pattern of files that may be of any preset: {map} is the only placeholder in
    /// braces that is allowed. Throws std::invalid_argument as above.
    explicit FilePattern(std::string_view pattern);

    /// Returns true if the files are vector files (vector/format.h).
    bool is_vector() const { return format_ == nullptr; }

    /// Returns the format of images. Precondition: is_vector() is false.
    const ImageFormat& format() const { return *format_; }

    /// Returns true if all maps of a frame are stored in one file: the format has layers and the
    /// pattern has no {map}.
    bool stores_all_maps_in_one_file() const;

    /// Throws std::invalid_argument if several frames would share a file, or if several maps would
    /// share a file although the format has no layers. `frames` and `maps` are the numbers of
    /// frames and maps.
    void check_distinct(std::size_t frames, std::size_t maps) const;

    /// Returns the path of the file that stores a map of a frame. `map` replaces {map}.
    std::filesystem::path path(std::string_view map, int frame) const;

    /// Returns the deepest folder that contains the files of all maps and frames; empty for the
    /// working directory.
    std::filesystem::path folder() const;

    /// Returns the paths of the files of a map as one text, in which the placeholder of the frame
    /// number is not replaced, such as "out/foam_albedo.####.png".
    std::string path_pattern(std::string_view map) const;

  private:
    // Returns the text that replaces a placeholder other than {map}. `name` is the placeholder
    // without its braces.
    using Placeholders = std::function<std::string(std::string_view name)>;

    struct MapName {};
    struct FrameNumber {
        int digits;
        std::string written;  // the placeholder as it is in the pattern
    };
    using Piece = std::variant<std::string, MapName, FrameNumber>;

    FilePattern(std::string_view pattern, const Placeholders& placeholders);

    Piece take_piece(std::string_view& rest, const Placeholders& placeholders) const;
    Piece take_word(std::string_view& rest, const Placeholders& placeholders) const;
    Piece take_format(std::string_view& rest) const;
    [[noreturn]] void reject(std::string_view reason) const;
    template <class Alternative>
    bool has() const;
    std::string fill(std::string_view map, std::optional<int> frame) const;

    std::string pattern_;
    const ImageFormat* format_;  // null for vector files
    std::vector<Piece> pieces_;
};

/// Returns a pattern that contains the placeholder {size}. If the given pattern contains it,
/// returns this pattern. Otherwise adds a folder {size} in the deepest folder that contains the
/// files of all maps and frames. For example, "out/{map}/####.png" becomes
/// "out/{size}/{map}/####.png".
std::string with_size_folder(std::string_view pattern);

/// Returns a pattern without the folders that the files of all maps and frames share. For example,
/// "out/{map}/####.png" becomes "{map}/####.png".
std::string without_shared_folders(std::string_view pattern);

}  // namespace foam::texgen
