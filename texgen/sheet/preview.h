#pragma once

#include "texgen/manifest/manifest.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// What a preview shows of a map.
enum class PreviewKind {
    Contact,  // up to 24 frames side by side, with their numbers
    Tiling,   // a frame 2 x 2 times
    Loop,     // an animated PNG
    Mp4,      // the same as a video; the program ffmpeg makes it
    Gif,
};

inline constexpr std::array<std::string_view, 5> kPreviewNames = {
    "contact", "tiling", "loop", "mp4", "gif"};

struct PreviewOptions {
    std::vector<std::string> maps = {};  // one of colours, or else no ids, if there are none
    std::vector<int> frames = {};        // in this order; all of the set if there are none
    std::vector<PreviewKind> kinds =
        {};          // if there are none: Contact, Loop, and Tiling of what tiles
    int size = 384;  // the longer side of frames that move, at most, in pixels
    int threads = 0;
};

/// Writes {preset}_{map}_contact.png, ..._tiling.png, ..._loop.png, .mp4 and .gif into a folder,
/// made as needed, and returns their names. Frames become smaller as ShownFrame says; all are
/// opaque. `folder` is that of the manifest. Throws as map_sequence, read_shown and encode_video,
/// and std::invalid_argument for a map of ids, of which nothing can be seen, and for the tiling of
/// a frame that does not tile.
std::vector<std::filesystem::path> write_previews(const BakedSet& set,
                                                  const std::filesystem::path& folder,
                                                  const PreviewOptions& options,
                                                  const std::filesystem::path& to);

}  // namespace foam::texgen
