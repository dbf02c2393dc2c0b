// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/manifest/manifest.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The kinds of previews of a map.
enum class PreviewKind {
    Contact,  // a contact sheet: up to 24 frames side by side, with their numbers
    Tiling,   // 2 x 2 copies of the first frame
    Loop,     // an animated PNG
    Mp4,      // the animation of Loop as an MP4, encoded by ffmpeg
    Gif,      // the animation of Loop as a GIF, encoded by ffmpeg
};

/// The names of the kinds of previews, in the order of PreviewKind.
inline constexpr std::array<std::string_view, 5> kPreviewNames = {
    "contact", "tiling", "loop", "mp4", "gif"};

/// The previews to write.
struct PreviewOptions {
    // If empty, the first map of colors is shown or, if there is none, the first map of numbers.
    std::vector<std::string> maps = {};
    std::vector<int> frames = {};  // shown in this order; empty for all frames of the set
    // If empty, Contact and Loop are written, and also Tiling if the first frame tiles.
    std::vector<PreviewKind> kinds = {};
    int size = 384;   // largest width and height of animations, in pixels
    int threads = 0;  // 0: one per hardware thread
};

/// Throws std::invalid_argument if a preview of the kind Tiling is wanted (options.kinds), but
/// `tiles` is false. `tiles` tells whether the first frame tiles; `frame` is its number, and
/// `preset` the name of its preset, both for the message.
void check_tiling(const PreviewOptions& options, bool tiles, int frame, const std::string& preset);

/// Throws std::invalid_argument if the samples of a map are whole numbers, such as ids, which
/// cannot be shown as a picture.
void check_shown_map(const std::string& map, bool stores_ids);

/// Writes previews of a baked set into the folder `to`, and returns their paths. PNG files are
/// named {preset}_{map}_{kind}.png, where {kind} is contact, tiling or loop. Videos are named
/// {preset}_{map}.mp4 and {preset}_{map}.gif. Frames are composited over gray, and large frames are
/// reduced in size (display_frame.h). `folder` is the folder of the manifest. `to` is created if
/// needed. `on_progress` receives the phase Previews.
///
/// Throws std::invalid_argument if no map was baked, or if a map has integers that must not be
/// averaged (ids or sides). Also throws std::invalid_argument if the kind Tiling is asked for, but
/// the first frame does not tile. Throws OutputError if a file cannot be written. Also throws the
/// exceptions of map_sequence, read_display_frame, ApngMuxer and encode_video.
std::vector<std::filesystem::path> write_previews(const BakedSet& set,
                                                  const std::filesystem::path& folder,
                                                  const PreviewOptions& options,
                                                  const std::filesystem::path& to,
                                                  const ProgressCallback& on_progress = {});

}  // namespace foam::texgen
