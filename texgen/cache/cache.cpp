#include "texgen/cache/cache.h"

#include "texgen/bake/camera.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/loop_pose.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/state_codec.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

namespace foam::texgen {

namespace {

// Hands out frames from the states of a cache. Frames that come soon after each other need the
// same states.
class Replay {
  public:
    Replay(const Cache& cache, const Preset& preset, NextFrames next_frames)
        : cache_(cache), preset_(preset), next_frames_(next_frames) {
        if (preset.shape.kind == FoamKind::Patch) {
            view_ = camera_view(*state(1).frame, preset.image, preset.camera);
        }
    }

    SimulatedFrame frame(int number) {
        SimulatedFrame shown = state(shown_number(number));
        if (shown.frame->number != number) {
            Frame renumbered = *shown.frame;
            renumbered.number = number;
            shown.frame = std::make_shared<const Frame>(std::move(renumbered));
        }
        if (next_frames_ == NextFrames::HandedOut) {
            shown.next = state(shown_number(number + 1)).frame;
        }
        shown.view = view_;
        shown.closing_error = cache_.info().closing_error;
        return shown;
    }

  private:
    int shown_number(int number) const {
        return shown_frame(number, preset_.loop, preset_.frames.count);
    }

    const SimulatedFrame& state(int number) {
        const auto found = kept_.find(number);
        if (found != kept_.end()) {
            return found->second;
        }
        constexpr std::size_t kKept = 2;  // a frame and the one after it
        if (kept_.size() == kKept) {
            kept_.erase(kept_.begin()->first < number ? kept_.begin() : std::prev(kept_.end()));
        }
        return kept_.emplace(number, cache_.state(number)).first->second;
    }

    const Cache& cache_;
    const Preset& preset_;
    NextFrames next_frames_;
    std::optional<View> view_;
    std::map<int, SimulatedFrame> kept_;
};

}  // namespace

bool is_cache(const std::filesystem::path& path) {
    return std::filesystem::exists(path / kCacheName);
}

Cache::Cache(std::filesystem::path folder) : folder_(std::move(folder)), info_(read_info(folder_)) {
    const std::filesystem::path path = pressures_path(folder_);
    if (std::filesystem::exists(path)) {
        first_pressures_ = unpack_numbers(read_packed(path, {"scale", info_.simulation}));
    }
}

SimulatedFrame Cache::state(int number) const {
    const std::filesystem::path path = state_path(folder_, number);
    if (!std::filesystem::exists(path)) {
        throw InputError(fmt::format("the cache '{}' has no frame {}: it was made for frames {}",
                                     folder_.string(),
                                     number,
                                     format_frame_range(info_.frames)));
    }
    try {
        return unpack_state(read_packed(path, {"state", info_.simulation}), first_pressures_);
    } catch (const BadContent& error) {
        throw InputError(fmt::format("cannot read '{}': {}", path.string(), error.what()));
    }
}

FrameSource Cache::frames_of(const Preset& preset) const {
    return
        [this, preset](
            const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor& on_frame) {
            Replay replay(*this, preset, next_frames);
            std::vector<int> in_order = numbers;
            std::ranges::sort(in_order);
            for (const int number : in_order) {
                on_frame(replay.frame(number));
            }
            return RunOutcome{RunStatus::Complete, 0, info_.closing_error};
        };
}

}  // namespace foam::texgen
