// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace foam::texgen {

/// Selects whether a bake keeps the files of an earlier bake that was stopped.
enum class Resume { No, Yes };

/// The options of bake_recorded that concern the images of earlier bakes.
struct RecordOptions {
    Resume resume = Resume::No;
    // Called if the bake replaces files of other sets (BakedSet) of the manifest, before the first
    // file is replaced. May be empty.
    std::function<void(const std::vector<ReplacedFiles>&)> on_replace = {};
};

/// Bakes a preset and records its images in a manifest. The manifest is written when the first
/// frame has been simulated, repeatedly while files are written, and at the end of the bake. It is
/// also written if the bake fails, unless an exception is thrown while automatic ranges are fitted
/// or before the first frame has been simulated. The manifest lists a file of this bake only if the
/// file has been kept or is already written. Returns the summary of the bake, including the files
/// that were kept.
///
/// With Resume::Yes, the files of the frames that existing_frames_of returns are kept. These frames
/// are still requested from their source, which is usually the simulation. There is one exception.
/// If the files of all frames in `options.frames` are kept and `callbacks.on_frame` is empty, the
/// bake has nothing to do and requests no frames.
///
/// Before the bake, automatic ranges of maps (keys with the value "auto") are fitted to the frames
/// in BakeOptions::sequence. If this sequence is the whole animation and the bake has nothing to
/// do, nothing is fitted. If the sequence is not the whole animation, as in a cache of some frames,
/// the ranges are recorded as numbers instead of "auto". The images then belong to a set of their
/// own. If the frames come from a cache (BakeOptions::cache), ranges that the cache stores are not
/// fitted again (StoredRanges).
///
/// Throws these exceptions before anything is simulated:
/// - the exceptions of check_bake;
/// - std::invalid_argument if the name of a file is not UTF-8 or is the name of the manifest;
/// - OutputError if the manifest cannot be written into its folder.
/// Later, throws the exceptions of bake and update_manifest, and InputError if a frame of the
/// sequence is missing in a cache.
BakeSummary bake_recorded(const Preset& given,
                          const BakeOptions& options,
                          const BakeCallbacks& callbacks,
                          const RecordOptions& record = {});

}  // namespace foam::texgen
