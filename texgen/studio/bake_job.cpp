// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/bake_job.h"

#include "core/files/shown_text.h"
#include "texgen/animation/phase_clock.h"
#include "texgen/animation/progress.h"
#include "texgen/animation/progress_text.h"
#include "texgen/bake/bake.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/material/scene_files.h"
#include "texgen/sheet/flipbook.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

/// Ends a bake that a page has canceled, or that runs while the studio ends.
class Canceled : public std::exception {};

}  // namespace

struct BakeJobs::Job {
    int number = 0;
    Preset preset;
    std::vector<int> frames;
    bool resume = false;
    std::atomic<bool> is_canceled = false;

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
        if (is_canceled) {
            throw Canceled();
        }
        const std::scoped_lock lock(mutex);
        progress = latest;
        clock.add(latest, PhaseClock::Clock::now());
    }

    void finish(const std::string& verdict, const std::string& reason) {
        const std::scoped_lock lock(mutex);
        status = verdict;
        message = shown_text(reason);
        end = PhaseClock::Clock::now();
    }
};

BakeJobs::BakeJobs(const StudioFolder& folder, FrameStore& store)
    : folder_(folder), store_(store) {}

BakeJobs::~BakeJobs() {
    stop();
}

Json BakeJobs::start(const BakeRequest& request) {
    BakePlan plan = plan_of(request, folder_);
    check_bake(plan.preset, {.frames = plan.frames});
    check_sheets(plan.preset);
    check_sheet_folder(plan.preset);
    check_scenes(plan.preset);
    const std::scoped_lock lock(mutex_);
    if (job_) {
        const std::scoped_lock job_lock(job_->mutex);
        if (job_->status == "running") {
            throw BakeIsRunning("another bake is running; wait for it or cancel it");
        }
    }
    if (job_ && job_->thread.joinable()) {
        job_->thread.join();
    }
    auto next = std::make_unique<Job>();
    next->number = ++count_;
    next->preset = std::move(plan.preset);
    next->frames = std::move(plan.frames);
    next->resume = request.resume;
    next->thread = std::thread([this, job = next.get()] { run(*job); });
    job_ = std::move(next);
    return {{"bake", count_},
            {"command", plan.command.empty() ? Json(nullptr) : Json(plan.command)}};
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
    } catch (const Canceled&) {
        job.finish("canceled", "");
    } catch (const std::bad_alloc&) {
        job.finish("failed", "out of memory: use smaller images, fewer maps or fewer bubbles");
    } catch (const std::exception& error) {
        job.finish("failed", error.what());
    }
}

BakeJobs::Job& BakeJobs::job(int bake) {
    if (!job_ || job_->number != bake) {
        throw std::invalid_argument(
            fmt::format("bake {} is not the last bake that was started", bake));
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
    job(bake).is_canceled = true;
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
        job_->is_canceled = true;
        job_->thread.join();
    }
}

}  // namespace foam::texgen
