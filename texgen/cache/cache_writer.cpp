// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache_writer.h"

#include "core/files/abandoned_files.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/state_codec.h"
#include "texgen/preset/simulation_keys.h"

#include <optional>
#include <utility>

namespace foam::texgen {

CacheWriter::CacheWriter(const Preset& preset,
                         std::vector<int> frames,
                         std::filesystem::path folder)
    : info_{.preset = preset,
            .version = FOAMTEX_VERSION,
            .simulation = simulation_hash(preset),
            .frames = std::move(frames),
            .closing_error = {}},
      folder_(std::move(folder)) {}

void CacheWriter::write(const SimulatedFrame& state) {
    if (!begun_) {
        begin(state.closing_error);
    }
    if (first_pressures_.empty() && !state.record->first_pressures.empty()) {
        first_pressures_ = state.record->first_pressures;
        // The kind of this packed file is "scale", because these pressures define the pressure
        // scale of all frames.
        write_packed(
            pressures_path(folder_), {"scale", info_.simulation}, pack_numbers(first_pressures_));
    }
    write_packed(state_path(folder_, state.frame->number),
                 {"state", info_.simulation},
                 pack_state(state, first_pressures_));
}

void CacheWriter::begin(const std::optional<double>& closing_error) {
    begun_ = true;
    info_.closing_error = closing_error;
    make_folders(folder_);
    remove_abandoned_files(folder_);
    write_info(info_, folder_);
}

}  // namespace foam::texgen
