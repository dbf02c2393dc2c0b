// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/bake_job.h"

#include "texgen/animation/progress_text.h"
#include "texgen/bake/bake.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/format.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/material/profile.h"
#include "texgen/material/scene_files.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/preset_io.h"
#include "texgen/sheet/flipbook.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <new>
#include <numeric>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kDefaultFolder = "out/";

/// Ends a bake that a page has cancelled.
class Cancelled : public std::exception {};

/// A bake, ready to run.
struct Plan {
    Preset preset;
    std::vector<int> frames = {};
    std::string command = {};  // empty if the command line cannot express the settings
};

std::vector<int> frames_of(const BakeRequest& request, const Preset& preset) {
    if (request.frames) {
        return parse_frame_range(*request.frames);
    }
    std::vector<int> frames(static_cast<std::size_t>(preset.frames.count));
    std::iota(frames.begin(), frames.end(), 1);
    return frames;
}

/// Returns a pattern of file names without the folder "out", in which images are written by
/// default.
std::string without_default_folder(std::string pattern) {
    if (pattern.starts_with(kDefaultFolder)) {
        pattern.erase(0, kDefaultFolder.size());
    }
    return pattern;
}

std::string with_suffix(const std::string& pattern, const std::string& suffix) {
    return std::filesystem::path(pattern).replace_extension(suffix).string();
}

/// Returns the options of the command `bake` that, together with the settings, give the same
/// images. Paths are relative to the folder of the studio.
std::vector<std::string> options_of(const BakeRequest& request, const Preset& preset) {
    std::vector<std::string> options;
    const auto add = [&](const char* name, const std::string& value) {
        options.insert(options.end(), {name, value});
    };
    if (request.profile) {
        add("--for", *request.profile);
    } else if (!request.maps.empty()) {
        add("--maps", fmt::format("{}", fmt::join(request.maps, ",")));
    }
    if (request.frames) {
        add("--frames", *request.frames);
    }
    if (request.size) {
        const auto [width, height] = *request.size;
        add("--size", fmt::format("{}x{}", width, height));
    }
    add("--out", preset.output.pattern);
    if (preset.output.sheets != SheetKind::None) {
        add("--set", "output.sheet_pattern=" + preset.output.sheet_pattern);
    }
    return options;
}

/// Returns the assignments that the request makes in addition to those of the settings.
std::vector<Assignment> assignments_of(const BakeRequest& request) {
    std::vector<Assignment> assignments;
    if (request.size) {
        const auto [width, height] = *request.size;
        assignments.push_back(
            {"size", "image.size", {Value::List{{std::int64_t{width}}, {std::int64_t{height}}}}});
    }
    if (!request.profile && !request.maps.empty()) {
        Value::List maps;
        for (const std::string& map : request.maps) {
            maps.push_back({map});
        }
        assignments.push_back({"maps", "image.maps", {std::move(maps)}});
    }
    return assignments;
}

/// Moves the images of a preset into a folder, which is a path relative to the folder of the
/// studio. Throws PathRejected if a pattern leaves it.
void place(Preset& preset, const BakeRequest& request, const StudioFolder& folder) {
    const std::filesystem::path base = request.folder;
    const auto below = [&](const std::string& pattern) {
        const std::string placed = (base / without_default_folder(pattern)).string();
        folder.below(placed);
        return placed;
    };
    OutputOptions& output = preset.output;
    output.pattern =
        below(request.profile ? output.pattern : with_suffix(output.pattern, request.format));
    output.sheet_pattern = below(output.sheet_pattern);
}

Plan plan_of(const BakeRequest& request, const StudioFolder& folder) {
    PagePreset loaded = load_settings(request.settings, folder);
    Plan plan{.preset = std::move(loaded.preset)};
    try {
        std::vector<Assignment> later = std::move(loaded.assignments);
        const std::vector<Assignment> own = assignments_of(request);
        later.insert(later.end(), own.begin(), own.end());
        if (request.profile) {
            // Only shipped profiles: a page must not read other files.
            assign(plan.preset,
                   profile_assignments(std::string(find_shipped_profile(*request.profile).name),
                                       load_settings({request.settings.preset}, folder).preset,
                                       later));
        }
        assign(plan.preset, later);
    } catch (const PresetError& error) {
        throw SettingsRejected(error.what(), "");
    }
    place(plan.preset, request, folder);
    plan.frames = frames_of(request, plan.preset);
    plan.command = bake_command(request.settings, options_of(request, plan.preset)).value_or("");
    OutputOptions& output = plan.preset.output;
    output.pattern = (folder.path() / output.pattern).string();
    output.sheet_pattern = (folder.path() / output.sheet_pattern).string();
    return plan;
}

std::array<int, 2> size_in(const JsonValue& value) {
    const std::vector<JsonValue> sides = value.items();
    if (sides.size() != 2) {
        value.reject("a list of a width and a height");
    }
    constexpr int kLargest = std::numeric_limits<int>::max();
    return {static_cast<int>(sides[0].integer(1, kLargest)),
            static_cast<int>(sides[1].integer(1, kLargest))};
}

}  // namespace

struct BakeJobs::Job {
    int number = 0;
    Preset preset;
    std::vector<int> frames;
    bool resume = false;
    std::atomic<bool> is_cancelled = false;

    std::mutex mutex = {};  // protects the members below, except the thread
    std::string status = "running";
    RunProgress progress = {};
    PhaseClock clock = {};
    PhaseClock::Clock::time_point begin = PhaseClock::Clock::now();
    PhaseClock::Clock::time_point end = begin;
    std::vector<std::filesystem::path> files = {};
    std::string message = {};

    std::thread thread = {};

    void report(const RunProgress& latest) {
        if (is_cancelled) {
            throw Cancelled();
        }
        const std::scoped_lock lock(mutex);
        progress = latest;
        clock.add(latest, PhaseClock::Clock::now());
    }

    void finish(const std::string& verdict, const std::string& reason) {
        const std::scoped_lock lock(mutex);
        status = verdict;
        message = reason;
        end = PhaseClock::Clock::now();
    }
};

BakeRequest read_bake_request(const JsonValue& request) {
    BakeRequest bake{.settings = read_settings(request), .folder = request["folder"].text()};
    if (const auto frames = request.find("frames")) {
        bake.frames = frames->text();
    }
    if (const auto format = request.find("format")) {
        constexpr std::array<std::string_view, 4> kFormats = {"png", "exr", "dds", "ktx2"};
        bake.format = format->word(kFormats);
    }
    if (const auto profile = request.find("profile")) {
        bake.profile = profile->text();
    }
    if (const auto maps = request.find("maps")) {
        for (const JsonValue& map : maps->items()) {
            bake.maps.push_back(map.text());
        }
    }
    if (const auto size = request.find("size")) {
        bake.size = size_in(*size);
    }
    if (const auto resume = request.find("resume")) {
        bake.resume = resume->flag();
    }
    return bake;
}

BakeJobs::BakeJobs(const StudioFolder& folder, FrameStore& store)
    : folder_(folder), store_(store) {}

BakeJobs::~BakeJobs() {
    stop();
}

Json BakeJobs::start(const BakeRequest& request) {
    Plan plan = plan_of(request, folder_);
    check_bake(plan.preset, {.frames = plan.frames});
    const std::scoped_lock lock(mutex_);
    if (job_) {
        const std::scoped_lock job_lock(job_->mutex);
        if (job_->status == "running") {
            throw BakeRuns("another bake is running; wait for it or cancel it");
        }
    }
    if (job_) {
        job_->thread.join();
    }
    const std::string command = plan.command;
    job_ = std::make_unique<Job>();
    job_->number = ++count_;
    job_->preset = std::move(plan.preset);
    job_->frames = std::move(plan.frames);
    job_->resume = request.resume;
    job_->thread = std::thread([this, job = job_.get()] { run(*job); });
    return {{"bake", count_}, {"command", command.empty() ? Json(nullptr) : Json(command)}};
}

void BakeJobs::run(Job& job) {
    const ProgressCallback report = [&](const RunProgress& progress) { job.report(progress); };
    const Preset& preset = job.preset;
    try {
        const BakeOptions options{.frames = job.frames, .source = store_.source(preset)};
        const BakeSummary summary =
            bake_recorded(preset,
                          options,
                          {.on_progress = report},
                          {.resume = job.resume ? Resume::Yes : Resume::No});
        std::vector<std::filesystem::path> files = summary.files;
        if (summary.outcome.status == RunStatus::Complete &&
            preset.output.sheets != SheetKind::None) {
            const Flipbook sheets = write_sheets(preset, job.frames, report);
            files.insert(files.begin(), sheets.files.begin(), sheets.files.end());
        }
        if (summary.outcome.status == RunStatus::Complete && !preset.output.scene.empty()) {
            const std::vector<std::filesystem::path> scenes = write_scenes(preset);
            files.insert(files.begin(), scenes.begin(), scenes.end());
        }
        {
            const std::scoped_lock lock(job.mutex);
            job.files = std::move(files);
        }
        const std::string failure = failure_of(summary.outcome);
        job.finish(failure.empty() ? "complete" : "failed", failure);
    } catch (const Cancelled&) {
        job.finish("cancelled", "");
    } catch (const std::bad_alloc&) {
        job.finish("failed", "out of memory: use smaller images, fewer maps or fewer bubbles");
    } catch (const std::exception& error) {
        job.finish("failed", error.what());
    }
}

BakeJobs::Job& BakeJobs::job(int bake) {
    if (!job_ || job_->number != bake) {
        throw std::invalid_argument(fmt::format("there is no bake {}", bake));
    }
    return *job_;
}

Json BakeJobs::status(int bake) {
    const std::scoped_lock lock(mutex_);
    Job& found = job(bake);
    const std::scoped_lock job_lock(found.mutex);
    const auto now = PhaseClock::Clock::now();
    const bool is_running = found.status == "running";
    if (is_running) {
        found.clock.advance(now);
    }
    const std::chrono::duration<double> passed = (is_running ? now : found.end) - found.begin;
    const std::string first =
        found.files.empty() ? "" : found.files.front().lexically_relative(folder_.path()).string();
    return {{"status", found.status},
            {"phase", name_of(found.progress.phase)},
            {"text", phase_text(found.progress)},
            {"done", found.progress.done},
            {"total", found.progress.total},
            {"seconds", passed.count()},
            {"seconds_left", number_or_null(is_running ? found.clock.seconds_left() : 0.0)},
            {"files", found.files.size()},
            {"first_file", first},
            {"message", found.message}};
}

void BakeJobs::cancel(int bake) {
    const std::scoped_lock lock(mutex_);
    job(bake).is_cancelled = true;
}

bool BakeJobs::is_running() {
    const std::scoped_lock lock(mutex_);
    if (!job_) {
        return false;
    }
    const std::scoped_lock job_lock(job_->mutex);
    return job_->status == "running";
}

void BakeJobs::stop() {
    const std::scoped_lock lock(mutex_);
    if (job_ && job_->thread.joinable()) {
        job_->is_cancelled = true;
        job_->thread.join();
    }
}

}  // namespace foam::texgen
