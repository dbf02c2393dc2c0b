#include "texgen/bake/bake.h"

#include "texgen/bake/bounded_workers.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/simulate_frames.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

int thread_count(const BakeOptions& options) {
    if (options.threads > 0) {
        return options.threads;
    }
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Draws frames into files and tells of them; called from several threads.
class FrameWriter {
  public:
    FrameWriter(const Preset& preset, int total, const ProgressCallback& on_progress)
        : preset_(preset), files_(preset), on_progress_(on_progress) {
        progress_.total = total;
    }

    const FrameFiles& files() const { return files_; }

    void write(const SimulatedFrame& shown, const std::optional<View>& view) {
        const RasterGrid grid{preset_.image.width, preset_.image.height, 0, 0, view};
        FrameLayers layers(
            {*shown.frame, *shown.record, shown.next.get(), files_.distance()}, grid, 1);
        files_.write(layers);
        report(*shown.frame, shown.effort);
    }

  private:
    void report(const Frame& frame, const FrameEffort& effort) {
        const std::scoped_lock lock(mutex_);
        ++progress_.done;
        progress_.frame = frame.number;
        progress_.bubbles = static_cast<int>(frame.bubbles.size() + frame.lone_bubbles.size());
        progress_.area_error = effort.area_error;
        progress_.angle_error = effort.angle_error;
        progress_.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        if (on_progress_) {
            on_progress_(progress_);
        }
    }

    const Preset& preset_;
    FrameFiles files_;
    const ProgressCallback& on_progress_;
    std::mutex mutex_;
    BakeProgress progress_;
    Clock::time_point begin_ = Clock::now();
};

void check(const Preset& preset, const BakeOptions& options) {
    if (options.frames.empty() ||
        *std::min_element(options.frames.begin(), options.frames.end()) < 1) {
        throw std::invalid_argument("a bake needs frames, numbered from 1");
    }
    FilePattern(preset.output.pattern)
        .check_distinct(options.frames.size(), preset.image.maps.size());
}

}  // namespace

BakeSummary bake(const Preset& preset,
                 const BakeOptions& options,
                 const ProgressCallback& on_progress,
                 const FrameVisitor& on_frame) {
    check(preset, options);
    FrameWriter writer(preset, static_cast<int>(options.frames.size()), on_progress);
    BakeSummary summary;
    Simulation simulation(preset, options.threads);
    BoundedWorkers workers(thread_count(options) - 1);
    const auto visit = [&](const SimulatedFrame& shown) {
        if (on_frame) {
            on_frame(shown);
        }
        workers.submit([shown, view = simulation.view(), &writer] { writer.write(shown, view); });
    };
    const NextFrames next =
        writer.files().needs_next() ? NextFrames::HandedOut : NextFrames::LeftOut;
    summary.outcome = simulate_frames(simulation, options.frames, next, visit);
    workers.finish();
    for (const int frame : options.frames) {
        if (summary.outcome.status == RunStatus::Complete || frame < summary.outcome.failed_frame) {
            const std::vector<std::filesystem::path> paths = writer.files().paths(frame);
            summary.files.insert(summary.files.end(), paths.begin(), paths.end());
        }
    }
    return summary;
}

}  // namespace foam::texgen
