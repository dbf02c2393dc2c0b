// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache.h"

#include "texgen/animation/camera.h"
#include "texgen/animation/frame_assembly.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/state_codec.h"

#include <fmt/core.h>

#include <utility>

namespace foam::texgen {

Cache::Cache(std::filesystem::path folder) : folder_(std::move(folder)), info_(read_info(folder_)) {
    const std::filesystem::path path = pressures_path(folder_);
    if (std::filesystem::exists(path)) {
        first_pressures_ = unpack_numbers(read_packed(path, {"scale", info_.simulation}));
    }
}

SimulatedFrame Cache::state(int number) const {
    const std::filesystem::path path = state_path(folder_, number);
    if (!std::filesystem::exists(path)) {
        throw InputError(fmt::format(
            "the cache '{}' has no state {}; it was simulated for frames {}, and only these can be "
            "drawn",
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
    return [this, preset](const std::vector<int>& numbers,
                          NextFrames next_frames,
                          const FrameVisitor& on_frame,
                          const ProgressCallback& on_progress) {
        std::optional<View> view;
        FrameAssembly assembly(preset, numbers, next_frames, on_frame);
        RunProgress progress{.phase = Phase::States,
                             .total = static_cast<int>(assembly.states().size())};
        for (const int number : assembly.states()) {
            if (on_progress && progress.done > 0) {
                on_progress(progress);
            }
            SimulatedFrame read = state(number);
            if (preset.shape.kind == FoamKind::Patch && number == 1) {
                view = camera_view(*read.frame, preset.image, preset.camera);
            }
            read.view = view;
            read.closing_error = info_.closing_error;
            assembly.add(read);
            ++progress.done;
        }
        return RunOutcome{RunStatus::Complete, 0, info_.closing_error};
    };
}

}  // namespace foam::texgen
