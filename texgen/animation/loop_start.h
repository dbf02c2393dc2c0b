// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle_drive.h"
#include "core/foam/foam.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A state from which a breathe, shear or boil loop closes in its next cycle. Finding such a state
/// takes many cycles. For some shipped presets, a start is stored in presets/loops and in the
/// program. If `foamtex simulate` has to search for the start of a boil, it stores the start in the
/// cache, beside the states.
struct LoopStart {
    Foam foam;         // at position 0 of the cycle
    CycleDrive drive;  // what each step of the cycle does with each bubble
    // The pressures at the end of the warm-up, in increasing order (FoamRecord::first_pressures).
    std::vector<double> first_pressures;
};

/// Returns a hash of the version of foamtex and of everything in the preset that determines how its
/// loop closes. Unlike simulation_hash, it ignores the keys that only change how the closed loop is
/// shown. These keys are the drift and the current of the loop, and the smoothing of values.
std::string loop_hash(const Preset& preset);

/// Returns the content of a file of presets/loops: the foam as a state file (core/io/foam_json.h)
/// with an additional first member "loop". This member contains the hash, the drive and the
/// pressures. `hash` is the loop_hash of the preset.
std::string write_loop_start(const LoopStart& start, const std::string& hash);

/// Parses the content of a file of presets/loops. `file` is its name in error messages. Throws
/// FormatError or InputError if the content does not have the form that write_loop_start writes.
LoopStart read_loop_start(std::string_view text, const std::string& file);

/// Reads the start of the loop of a preset from `text`, a result of write_loop_start, which begins
/// with a hash. Returns nullopt if this hash is not the loop_hash of the preset. `file` is the name
/// of the file in error messages. Throws the exceptions of read_loop_start. Also throws InputError
/// if the start is impossible for the preset, for example because its drive names a bubble that the
/// foam never had.
std::optional<LoopStart> matching_loop_start(const Preset& preset,
                                             std::string_view text,
                                             const std::string& file);

/// Returns the start of the loop of a preset if one is stored in the program, otherwise nullopt.
/// The start may have been stored for another preset: only loop_hash matters.
std::optional<LoopStart> stored_loop_start(const Preset& preset);

}  // namespace foam::texgen
