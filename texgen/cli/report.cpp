// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/report.h"

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/memory.h"
#include "texgen/manifest/set_choice.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/event_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace foam::texgen {

namespace {

/// Returns the keys that set the ranges of an image, and what to do with them to avoid clipping,
/// such as "raise height.full".
std::string advice_on_range(const DrawnImage& image, const MapOptions& options) {
    const auto maps = image.sources();
    const bool is_automatic = std::ranges::any_of(maps, [&](const Map* map) {
        const AutoReal* const range = range_option_of(*map, options);
        return range != nullptr && range->is_automatic;
    });
    return fmt::format(
        "{} {}", is_automatic ? "set" : "raise", fmt::join(image.range_keys(), " or "));
}

}  // namespace

void print_files(std::span<const std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        print_stdout("{}\n", file.string());
    }
}

void note_missing_charts(const StatisticsFiles& statistics) {
    if (statistics.charts == ChartStatus::Drawn) {
        return;
    }
    const bool missing = statistics.charts == ChartStatus::NoGnuplot;
    print_stderr(
        "foamtex: note: charts are missing, because gnuplot {}; to draw them, run in '{}': "
        "gnuplot {}",
        missing ? "is not installed" : "failed",
        statistics.paths.front().parent_path().string(),
        kChartsScriptName);
}

void note_other_version(const CacheInfo& cache, const std::filesystem::path& folder) {
    if (cache.version != FOAMTEX_VERSION) {
        print_stderr(
            "foamtex: note: the cache '{}' was simulated by foamtex {}; this is foamtex {}, "
            "which may simulate the same preset differently",
            folder.string(),
            cache.version,
            FOAMTEX_VERSION);
    }
}

void note_open_loop(const Preset& preset, std::span<const int> frames) {
    const int count = preset.frames.count;
    if (preset.loop.kind != LoopKind::None && !closes_loop(frames, count)) {
        print_stderr(
            "foamtex: note: the frames {} alone do not loop; the loop of '{}' has the "
            "frames 1-{}, and --set frames.count=N changes its length",
            format_frame_range(frames),
            preset.name,
            count);
    }
}

void warn_of_late_events(const Preset& preset, std::span<const int> frames) {
    const int last = std::max(preset.frames.count, *std::max_element(frames.begin(), frames.end()));
    std::vector<std::string> late;
    std::vector<std::string> unfinished;
    for (std::size_t k = 0; k < preset.events.size(); ++k) {
        const std::optional<FrameSpan> span = frames_of(preset.events[k], preset.frames);
        if (span && span->first > last) {
            late.push_back(fmt::format("event[{}] begins at frame {}", k + 1, span->first));
        } else if (span && span->last > last) {
            unfinished.push_back(fmt::format("event[{}] ends at frame {}", k + 1, span->last));
        }
    }
    const auto warn = [&](std::string_view what, const std::vector<std::string>& events) {
        if (!events.empty()) {
            print_stderr("foamtex: warning: events of '{}' {} {}: {}; raise frames.count",
                         preset.name,
                         what,
                         last,
                         fmt::join(events, ", "));
        }
    };
    warn("never happen, because they begin after the last frame,", late);
    warn("are cut off at the last frame,", unfinished);
}

void warn_of_missing_bubbles(const Preset& preset, const RunOutcome& outcome) {
    for (std::size_t k = 0; k < outcome.missing_bubbles.size(); ++k) {
        const Event& event = preset.events[k];
        const int missing = outcome.missing_bubbles[k];
        if (missing == 0) {
            continue;
        }
        const bool creates = find_event_kind(event.kind).creates_bubbles;
        const std::size_t wanted =
            creates ? static_cast<std::size_t>(event.count) : event.chosen_count();
        print_stderr("foamtex: warning: event[{}] ({}) {} {} of {} {}",
                     k + 1,
                     event.kind,
                     creates ? "could not create" : "did not find",
                     missing,
                     wanted,
                     wanted == 1 ? "bubble" : "bubbles");
    }
}

void warn_of_full_disk(std::uint64_t size, const std::filesystem::path& folder) {
    std::error_code error;
    const std::filesystem::space_info space =
        std::filesystem::space(nearest_existing(folder), error);
    if (!error && space.capacity > 0 && size > space.available) {
        print_stderr(
            "foamtex: warning: the files need about {}, but the disk of '{}' has only {} left",
            amount_of_bytes(size),
            folder.empty() ? "." : folder.string(),
            amount_of_bytes(space.available));
    }
}

void warn_of_replaced_files(const std::vector<ReplacedFiles>& replaced) {
    for (const ReplacedFiles& files : replaced) {
        print_stderr(
            "foamtex: warning: this replaces {} {} of another bake, {}; to keep both, give this "
            "bake a folder of its own, such as --out "
            "'{{preset}}_{{size}}_{{seed}}/{{map}}.####.png'",
            files.count,
            files.count == 1 ? "image" : "images",
            name_of(*files.set));
    }
}

void warn_of_clipped(const BakeSummary& summary, const Preset& preset) {
    for (const WrittenNumbers& numbers : summary.numbers) {
        if (numbers.extent.clipped > 0.0) {
            print_stderr(
                "foamtex: warning: {}: in a file, up to {:.3g} % of the samples are outside of "
                "{:g} to {:g} and were clipped; before clipping, the numbers of all files were "
                "from {:.3g} to {:.3g}; {}",
                numbers.image.name(),
                100.0 * numbers.extent.clipped,
                numbers.range[0],
                numbers.range[1],
                numbers.extent.smallest,
                numbers.extent.largest,
                advice_on_range(numbers.image, preset.maps));
        }
    }
}

void report_earlier_sheets(const Flipbook& flipbook) {
    const auto& [unlisted, replaced] = flipbook.earlier;
    const std::string description = flipbook.files.back().string();
    if (!replaced.empty()) {
        print_stderr(
            "foamtex: warning: the sheets {} of another bake were replaced; to keep the sheets of "
            "two bakes, write them to different folders",
            fmt::join(replaced, ", "));
    }
    if (!unlisted.empty()) {
        print_stderr(
            "foamtex: note: '{}' no longer lists {}: these sheets have another layout or other "
            "frames, or were made from another bake",
            description,
            fmt::join(unlisted, ", "));
    }
}

ExitCode report_failure(const RunOutcome& outcome) {
    const bool is_open = outcome.status == RunStatus::OpenLoop;
    print_stderr("foamtex: {}{}",
                 failure_of(outcome),
                 is_open ? "; use a smaller loop.amplitude or more loop.cycles" : "");
    return ExitCode::NoEquilibrium;
}

}  // namespace foam::texgen
