// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"

#include <filesystem>

namespace foam::texgen {

/// Returns the folder of the manifest of a preset: the deepest folder that contains all of its
/// images, for any maps and frames.
std::filesystem::path manifest_folder(const Preset& preset);

/// Selects whether a bake keeps the files of an earlier bake that was stopped.
enum class Resume { No, Yes };

/// Bakes and keeps a manifest. The manifest is written when the first frame has been simulated,
/// repeatedly while files are written, and at the end of the bake, also if it fails. It lists only
/// files that have been written. With Resume::Yes, the files of the frames that existing_frames_of
/// returns are kept. These frames are simulated nevertheless, unless all frames exist and
/// `on_frame` is empty. Throws the exceptions of bake and update_manifest.
BakeSummary bake_recorded(const Preset& preset,
                          const BakeOptions& options,
                          const BakeCallbacks& callbacks,
                          Resume resume = Resume::No);

}  // namespace foam::texgen
