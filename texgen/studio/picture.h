// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/preset/preset.h"
#include "texgen/studio/frame_store.h"
#include "texgen/studio/http_message.h"

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace foam::texgen {

/// The largest width and height of a picture that a page can ask for, in pixels.
inline constexpr int kMaxPictureSide = 2048;

/// The quality of a picture, which determines how long a page waits for it.
enum class PictureQuality {
    Draft,  // frame 1 without the warm-up, the events and the loop (FrameStore::draft)
    Full,   // the frame itself; an automatic range is fitted to this picture, until the range of
            // all frames is known
    Exact,  // as Full, but a range is fitted to all frames, as in a bake, if all of them are kept
};

/// A picture that a page asks for.
struct PictureRequest {
    std::string page;  // the word that the page has chosen (REQUESTS.md)
    int frame = 1;
    std::string map;
    int side = kMaxPictureSide;  // largest width and height in pixels (reduced_image)
    PictureQuality quality = PictureQuality::Full;
    // True for floats in the unit of the map; false for codes (integers, as in a PNG) of 8 bits.
    bool floats = false;
};

/// Draws the pictures of the pages. Keeps the data that the maps of recent frames share, such as
/// distances to films, so that the same frame is drawn quickly with other colors. Thread-safe.
class Painter {
  public:
    /// Keeps a reference to the store.
    explicit Painter(FrameStore& store);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Returns the answer to /api/picture (REQUESTS.md). Throws std::invalid_argument if the map
    /// does not exist, and the exceptions of FrameStore.
    HttpResponse draw(const Preset& preset, const PictureRequest& request);

    /// Returns the answer to /api/pick for the pixel in column x and row y, counted from the upper
    /// left and clamped to the picture. Throws the same exceptions as `draw`.
    Json pick(const Preset& preset, const PictureRequest& request, int x, int y);

  private:
    struct SharedData;  // a frame, and the data that its maps share
    struct DrawnMap;    // an image, and whether it is exact

    std::shared_ptr<SharedData> shared_data(const Preset& preset, const PictureRequest& request);
    DrawnMap draw_map(const Preset& preset, const PictureRequest& request, SharedData& frame);
    bool fit_range(const Preset& preset, const PictureRequest& request, MapOptions& options);

    FrameStore& store_;
    std::mutex fitting_mutex_;  // held while a range is fitted
    std::mutex mutex_;          // protects the members below
    std::list<std::pair<std::string, std::shared_ptr<SharedData>>> kept_;  // the newest is first
    std::map<std::string, double> ranges_;  // fitted ranges, by simulation, map and options
};

}  // namespace foam::texgen
