#include "texgen/bake/bake.h"

#include "texgen/bake/bounded_workers.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/simulation.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"
#include "texgen/maps/albedo.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <system_error>
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

void make_folder_of(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::create_directories(folder, error) && error) {
        throw OutputError(
            fmt::format("{}: cannot make the folder: {}", folder.string(), error.message()));
    }
}

// What every file of a bake says about itself.
PngMetadata metadata_of(const Preset& preset) {
    return {.color = true,
            .text = {{"Title", preset.description},
                     {"Software", "foamtex " FOAMTEX_VERSION},
                     {"Seed", fmt::format("{}", preset.seeding.seed)},
                     {"Preset", to_toml(preset)}}};
}

// Draws frames into files and tells of them; called from several threads.
class FrameWriter {
  public:
    FrameWriter(const Preset& preset, int total, const ProgressCallback& on_progress)
        : preset_(preset),
          pattern_(preset.output.pattern),
          metadata_(metadata_of(preset)),
          on_progress_(on_progress) {
        progress_.total = total;
    }

    std::vector<std::filesystem::path> paths(int frame) const {
        std::vector<std::filesystem::path> all;
        for (const std::string& map : preset_.image.maps) {
            all.push_back(pattern_.path(preset_.name, map, frame));
        }
        return all;
    }

    void write(const Frame& frame, const EquilibriumSummary& equilibrium) {
        const RasterGrid grid{preset_.image.width, preset_.image.height};
        const Image<std::uint8_t> image = albedo(frame, grid, preset_.albedo, 1);
        for (const std::filesystem::path& path : paths(frame.number)) {
            make_folder_of(path);
            write_png(path, image.view(), metadata_);
        }
        report(frame, equilibrium);
    }

  private:
    void report(const Frame& frame, const EquilibriumSummary& equilibrium) {
        const std::scoped_lock lock(mutex_);
        ++progress_.done;
        progress_.frame = frame.number;
        progress_.bubbles = static_cast<int>(frame.bubbles.size());
        progress_.area_error = equilibrium.area_error;
        progress_.angle_error = equilibrium.angle_error;
        progress_.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        if (on_progress_) {
            on_progress_(progress_);
        }
    }

    const Preset& preset_;
    FilePattern pattern_;
    PngMetadata metadata_;
    const ProgressCallback& on_progress_;
    std::mutex mutex_;
    BakeProgress progress_;
    Clock::time_point begin_ = Clock::now();
};

// Runs the foam to the last frame that is wanted, and hands out the wanted ones on the way.
BakeStatus simulate_frames(Simulation& simulation,
                           std::vector<int> wanted,
                           FrameWriter& writer,
                           BoundedWorkers& workers) {
    std::sort(wanted.begin(), wanted.end());
    for (const int number : wanted) {
        while (simulation.number() < number) {
            if (!simulation.advance()) {
                return BakeStatus::NoEquilibrium;
            }
        }
        const auto frame = std::make_shared<const Frame>(simulation.frame());
        workers.submit([frame, &writer, equilibrium = simulation.equilibrium()] {
            writer.write(*frame, equilibrium);
        });
    }
    return BakeStatus::Complete;
}

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
                 const ProgressCallback& on_progress) {
    check(preset, options);
    FrameWriter writer(preset, static_cast<int>(options.frames.size()), on_progress);
    BakeSummary summary;
    Simulation simulation(preset, options.threads);
    BoundedWorkers workers(thread_count(options) - 1);
    summary.status = simulate_frames(simulation, options.frames, writer, workers);
    workers.finish();
    if (summary.status == BakeStatus::NoEquilibrium) {
        summary.failed_frame = simulation.number();
    }
    for (const int frame : options.frames) {
        if (summary.status == BakeStatus::Complete || frame < summary.failed_frame) {
            const std::vector<std::filesystem::path> paths = writer.paths(frame);
            summary.files.insert(summary.files.end(), paths.begin(), paths.end());
        }
    }
    return summary;
}

}  // namespace foam::texgen
