#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

struct ImageFormat;

/// Names the image files of a bake. In the pattern stand for
///
///     {preset}  the name of the preset
///     {map}     the name of the map
///     #         the frame in four digits; a run of two or more: in as many digits as characters
///     @         the frame in as many digits as the run has characters
///     %04d %d   the frame as in C's printf
///
/// A number with more digits than asked for is written in full; shorter ones get leading zeros.
class FilePattern {
  public:
    /// Throws std::invalid_argument for a placeholder not listed above and unless the suffix of an
    /// image format ends it.
    explicit FilePattern(std::string_view pattern);

    const ImageFormat& format() const { return *format_; }

    /// Returns true if all maps of a frame go into one file: the format has layers and the pattern
    /// has no {map}.
    bool joins_maps() const;

    /// Throws std::invalid_argument if two of this many frames would share a file, or two of this
    /// many maps would that cannot.
    void check_distinct(std::size_t frames, std::size_t maps) const;

    std::filesystem::path path(std::string_view preset, std::string_view map, int frame) const;

    /// The deepest folder that holds the files of all maps and frames.
    std::filesystem::path folder(std::string_view preset) const;

    /// The path with the frame's placeholder left as the pattern has it.
    std::string sequence(std::string_view preset, std::string_view map) const;

  private:
    struct PresetName {};
    struct MapName {};
    struct FrameNumber {
        int digits;
        std::string written;
    };
    using Piece = std::variant<std::string, PresetName, MapName, FrameNumber>;

    Piece take_piece(std::string_view& rest) const;
    Piece take_word(std::string_view& rest) const;
    Piece take_format(std::string_view& rest) const;
    [[noreturn]] void refuse(std::string_view reason) const;
    template <class Wanted>
    bool has() const;
    std::string fill(std::string_view preset, std::string_view map, std::optional<int> frame) const;

    std::string pattern_;
    const ImageFormat* format_;
    std::vector<Piece> pieces_;
};

}  // namespace foam::texgen
