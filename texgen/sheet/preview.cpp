// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/preview.h"

#include "core/files/file_io.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/image/apng.h"
#include "texgen/image/png.h"
#include "texgen/sheet/contact_sheet.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/sheet/spread.h"
#include "texgen/sheet/video.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace foam::texgen {

namespace {

using Codes = Image<std::uint8_t>;

constexpr std::size_t kMaxThumbnails = 24;
constexpr int kThumbnailSize = 200;  // largest width and height of a thumbnail, in pixels
constexpr int kTileSize = 512;       // largest width and height of a tile, in pixels
constexpr int kTiles = 2;            // number of tiles (copies of the frame) in each direction

// Returns the 8-bit codes of a frame. The frame is reduced if its longer side exceeds `size`
// pixels.
Codes codes_within(const DisplayFrame& frame, int size) {
    const int width = frame.pixels.width();
    const int height = frame.pixels.height();
    const double scale = std::min(1.0, static_cast<double>(size) / std::max(width, height));
    const auto scaled = [scale](int extent) {
        return std::max(1, static_cast<int>(std::lround(extent * scale)));
    };
    return codes_of(reduced(frame, scaled(width), scaled(height)));
}

// Returns the 8-bit codes of all frames of a sequence (codes_within). `progress` counts each frame.
std::vector<Codes> frames_within(const MapSequence& sequence,
                                 int size,
                                 int threads,
                                 ProgressMeter& progress) {
    std::vector<Codes> frames(sequence.files.size());
    parallel_for(frames.size(), 1, threads, [&](std::size_t k, std::size_t) {
        frames[k] = codes_within(read_display_frame(sequence.files[k], sequence.map), size);
        progress.add();
    });
    return frames;
}

Codes tiled(const Codes& tile) {
    Codes tiling(kTiles * tile.width(), kTiles * tile.height(), tile.channels());
    for (int y = 0; y < tiling.height(); ++y) {
        const auto from = tile.row(y % tile.height());
        for (int k = 0; k < kTiles; ++k) {
            std::ranges::copy(from, tiling.pixel(k * tile.width(), y).data());
        }
    }
    return tiling;
}

// Encodes a picture as a PNG that is marked as sRGB colors, even if the map stores numbers.
Bytes encoded(const Codes& codes) {
    return encode_png(
        codes.view(), {.color = true, .text = {}}, {.compression = Compression::Small});
}

// Returns the frames as an animated PNG. `progress` counts each encoded frame.
Bytes animation(const std::vector<Codes>& frames,
                FrameRate rate,
                int threads,
                ProgressMeter& progress) {
    std::vector<Bytes> streams(frames.size());
    parallel_for(frames.size(), 1, threads, [&](std::size_t k, std::size_t) {
        streams[k] = encoded(frames[k]);
        progress.add();
    });
    ApngMuxer muxer(static_cast<int>(frames.size()), rate);
    for (const Bytes& stream : streams) {
        muxer.add(stream);
    }
    return muxer.finish();
}

// Returns the name of the map to show if the options name none: the first baked map of colors. If
// there is none, returns the first baked map of numbers. If there is none of numbers either,
// returns the first baked map of kind "id" or, as the last choice, the first map of vector files.
// The class Previews cannot show maps of these last two kinds, and throws an error that names the
// map. Throws std::invalid_argument if no map was baked.
std::string default_map(const BakedSet& set) {
    for (const std::string_view kind : {"color", "number", "id"}) {
        for (const ManifestMap& map : set.maps) {
            if (map.samples && map.samples->kind == kind) {
                return map.name;
            }
        }
    }
    for (const ManifestMap& map : set.maps) {
        if (!map.vector_format.empty()) {
            return map.name;  // map_sequence rejects it, because it has no pixels
        }
    }
    throw std::invalid_argument(fmt::format("no map of preset '{}' was baked", set.preset));
}

// Makes the previews of one map. The animated PNG is encoded only once, and reused for the videos.
class Previews {
  public:
    Previews(const BakedSet& set,
             const std::filesystem::path& folder,
             const PreviewOptions& options,
             const std::string& map)
        : set_(set), options_(options), sequence_(map_sequence(set, folder, map, options.frames)) {
        check_shown_map(map, sequence_.map.samples->kind == "id");
        const MapFile& first = sequence_.files.front();
        check_tiling(options, first.tiles, first.frame, set.preset);
    }

    std::vector<PreviewKind> kinds() const {
        if (!options_.kinds.empty()) {
            return options_.kinds;
        }
        std::vector<PreviewKind> kinds{PreviewKind::Contact, PreviewKind::Loop};
        if (sequence_.files.front().tiles) {
            kinds.push_back(PreviewKind::Tiling);
        }
        return kinds;
    }

    /// Returns the number of units of progress that `write` counts for all kinds together. Each
    /// thumbnail of the contact sheet and each file counts one unit. Each frame of the animation
    /// counts two: one for reducing it and one for encoding it.
    int units() const {
        const std::vector<PreviewKind> all = kinds();
        const std::size_t frames = sequence_.files.size();
        const auto is_animation = [](PreviewKind kind) { return kind >= PreviewKind::Loop; };
        std::size_t units = all.size();
        units += std::min(frames, kMaxThumbnails) *
                 static_cast<std::size_t>(std::ranges::count(all, PreviewKind::Contact));
        units += std::ranges::any_of(all, is_animation) ? 2 * frames : 0;
        return static_cast<int>(units);
    }

    std::filesystem::path write(PreviewKind kind,
                                const std::filesystem::path& to,
                                ProgressMeter& progress) {
        std::filesystem::path path = to / name(kind);
        write_file(path, make(kind, progress));
        progress.add();
        return path;
    }

  private:
    std::string name(PreviewKind kind) const {
        const std::string stem = set_.preset + '_' + sequence_.map.name;
        const std::string_view word = kPreviewNames.at(static_cast<std::size_t>(kind));
        const bool is_video = kind == PreviewKind::Mp4 || kind == PreviewKind::Gif;
        return is_video ? fmt::format("{}.{}", stem, word) : fmt::format("{}_{}.png", stem, word);
    }

    FrameRate rate() const { return playing_rate(set_, options_.frames); }

    Bytes make(PreviewKind kind, ProgressMeter& progress) {
        switch (kind) {
            case PreviewKind::Contact:
                return contact(progress);
            case PreviewKind::Tiling:
                return tiling();
            case PreviewKind::Loop:
                return loop(progress);
            case PreviewKind::Mp4:
                return encode_video(loop(progress), rate(), VideoFormat::Mp4);
            case PreviewKind::Gif:
                return encode_video(loop(progress), rate(), VideoFormat::Gif);
        }
        return {};
    }

    Bytes contact(ProgressMeter& progress) const {
        const MapSequence shown{sequence_.map, spread(sequence_.files, kMaxThumbnails)};
        std::vector<Codes> codes = frames_within(shown, kThumbnailSize, options_.threads, progress);
        std::vector<Thumbnail> thumbnails;
        for (std::size_t k = 0; k < codes.size(); ++k) {
            thumbnails.push_back({std::move(codes[k]), {{std::to_string(shown.files[k].frame)}}});
        }
        return encoded(contact_sheet(thumbnails));
    }

    Bytes tiling() const {
        const MapFile& file = sequence_.files.front();
        return encoded(tiled(codes_within(read_display_frame(file, sequence_.map), kTileSize)));
    }

    const Bytes& loop(ProgressMeter& progress) {
        if (loop_.empty()) {
            loop_ = animation(frames_within(sequence_, options_.size, options_.threads, progress),
                              rate(),
                              options_.threads,
                              progress);
        }
        return loop_;
    }

    const BakedSet& set_;
    const PreviewOptions& options_;
    MapSequence sequence_;
    Bytes loop_;
};

}  // namespace

void check_tiling(const PreviewOptions& options, bool tiles, int frame, const std::string& preset) {
    if (!tiles && std::ranges::count(options.kinds, PreviewKind::Tiling) > 0) {
        throw std::invalid_argument(
            fmt::format("frame {} of preset '{}' does not tile; the preview 'tiling' needs a torus "
                        "that is not sheared, or sheared by whole widths",
                        frame,
                        preset));
    }
}

void check_shown_map(const std::string& map, bool stores_ids) {
    if (stores_ids) {
        throw std::invalid_argument(
            fmt::format("map '{}' stores whole numbers, which cannot be shown as a picture; "
                        "the map 'id_color' shows bubbles by color",
                        map));
    }
}

std::vector<std::filesystem::path> write_previews(const BakedSet& set,
                                                  const std::filesystem::path& folder,
                                                  const PreviewOptions& options,
                                                  const std::filesystem::path& to,
                                                  const ProgressCallback& on_progress) {
    PreviewOptions full = options;
    if (full.frames.empty()) {
        full.frames = set.frames();
    }
    if (full.maps.empty()) {
        full.maps.push_back(default_map(set));
    }
    // All maps are checked before the first file is written.
    std::vector<Previews> previews;
    previews.reserve(full.maps.size());
    for (const std::string& map : full.maps) {
        previews.emplace_back(set, folder, full, map);
    }
    make_folders(to);
    int units = 0;
    for (const Previews& checked : previews) {
        units += checked.units();
    }
    ProgressMeter progress(Phase::Previews, units, on_progress);
    progress.begin();
    std::vector<std::filesystem::path> written;
    for (Previews& checked : previews) {
        Previews current = std::move(checked);  // its animation is freed before the next map
        for (const PreviewKind kind : current.kinds()) {
            written.push_back(current.write(kind, to, progress));
        }
    }
    return written;
}

}  // namespace foam::texgen
