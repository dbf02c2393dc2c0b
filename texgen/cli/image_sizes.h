// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/run_arguments.h"
#include "texgen/preset/preset.h"

#include <functional>
#include <vector>

namespace foam::texgen {

/// Changes the option --size, which `command` must have, so that its help says that it accepts
/// several sizes.
void describe_several_sizes(CLI::App& command);

/// Returns the preset of each size that --size lists, such as "2048,1024,512"; one preset if the
/// option has at most one size. `load` is called once for each size, with arguments that contain
/// only this size, and returns their preset. For each size except the first, these arguments have
/// `quiet` set, so that `load` prints notes only once.
///
/// With several sizes, with_size_folder changes output.pattern and output.sheet_pattern, so that
/// the images of each size get a folder of their own. A pattern that contains {size} is not
/// changed.
///
/// Throws the exceptions of `load`. Throws std::invalid_argument if a size occurs twice, or if
/// scene files of different sizes would have the same name. Also throws it if the sizes need
/// different simulations (simulation_hash), because their aspect ratios differ.
std::vector<Preset> presets_of_sizes(const RunArguments& arguments,
                                     const std::function<Preset(const RunArguments&)>& load);

}  // namespace foam::texgen
