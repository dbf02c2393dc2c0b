#pragma once

#include "texgen/bake/bake.h"

#include <filesystem>

namespace foam::texgen {

/// Where the manifest of a preset's images lies: the deepest folder that holds them all, whatever
/// the maps and frames.
std::filesystem::path manifest_folder(const Preset& preset);

/// Whether a bake goes on where one before it stopped.
enum class Resume { No, Yes };

/// A bake that leaves a manifest. It is written when the first frame has been simulated, while the
/// files come, and at the end, however the bake ends; what is not there yet is not in it. To
/// resume is to keep present_frames; their foam is simulated all the same, unless that is all of
/// them. Throws as bake and update_manifest.
BakeSummary bake_recorded(const Preset& preset,
                          const BakeOptions& options,
                          const BakeCallbacks& callbacks,
                          Resume resume = Resume::No);

}  // namespace foam::texgen
