// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/bake/bake.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cli/exit_code.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"
#include "texgen/sheet/flipbook.h"
#include "texgen/stats/files.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace foam::texgen {

/// Prints the paths of files on stdout, one per line.
void print_files(std::span<const std::filesystem::path> files);

/// If gnuplot is not installed or has failed, prints a note on stderr that says so and gives the
/// command that draws the charts.
void note_missing_charts(const StatisticsFiles& statistics);

/// Prints a note on stderr if the states of a cache were simulated by another version of foamtex.
/// `folder` is the folder of the cache.
void note_other_version(const CacheInfo& cache, const std::filesystem::path& folder);

/// Prints a note on stderr if the preset has a loop, but the frames that were baked do not close it
/// (closes_loop). Precondition: `frames` is not empty.
void note_open_loop(const Preset& preset, std::span<const int> frames);

/// Prints a warning on stderr if events of the preset never happen, because they begin after the
/// last frame. Prints another one if events are cut off, because they end after the last frame. The
/// last frame is frames.count or the largest of the given frames, whichever is larger.
/// Precondition: `frames` is not empty.
void warn_of_late_events(const Preset& preset, std::span<const int> frames);

/// Prints a warning on stderr for each event that did not find all bubbles that it was to change,
/// or could not create all bubbles that it was to create.
void warn_of_missing_bubbles(const Preset& preset, const RunOutcome& outcome);

/// Prints a warning on stderr if files of the given total size, in bytes, do not fit on the disk of
/// a folder. If the folder does not exist, the disk of the nearest existing folder above it counts.
void warn_of_full_disk(std::uint64_t size, const std::filesystem::path& folder);

/// Prints a warning on stderr for each element of `replaced`, that is, for each earlier bake whose
/// images this bake replaces. The warning says how to keep the images of both bakes.
void warn_of_replaced_files(const std::vector<ReplacedFiles>& replaced);

/// Prints a warning on stderr for each image of a bake that has clipped samples. The warning says
/// which keys set the range.
void warn_of_clipped(const BakeSummary& summary, const Preset& preset);

/// Prints on stderr which sheets of another bake the given flipbook has replaced. Also prints which
/// sheets of an earlier flipbook its JSON file no longer lists. Prints nothing if there are no such
/// sheets.
void report_earlier_sheets(const Flipbook& flipbook);

/// Prints on stderr why a run failed, and returns the exit code for this failure. Precondition: the
/// run failed.
ExitCode report_failure(const RunOutcome& outcome);

}  // namespace foam::texgen
