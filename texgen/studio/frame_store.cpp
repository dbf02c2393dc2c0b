// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/frame_store.h"

#include "core/files/shown_text.h"
#include "texgen/preset/simulation_keys.h"
#include "texgen/studio/frame_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

// A run (FrameRun) is the simulation of one foam. A single thread simulates one run after the
// other. The next run is always the unfinished run that a page has asked for last (want_run).

namespace foam::texgen {

namespace {

// The memory of a state per bubble, in bytes, rounded up from measurements.
constexpr std::size_t kBytesPerBubble = 2500;
constexpr std::size_t kMaxRuns = 8;     // largest number of kept runs
constexpr std::size_t kMaxDrafts = 48;  // largest number of kept drafts (FrameStore::draft)
// All drafts together may use this fraction of the memory that the runs may use: 1 / kDraftShare.
constexpr std::size_t kDraftShare = 4;

// Ends a simulation whose run is dropped, or whose store is stopped.
class Stopped : public std::exception {};

std::vector<int> numbers_to(int last) {
    std::vector<int> numbers(static_cast<std::size_t>(last));
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

// Returns the memory of a state of the foam of a preset, in bytes.
std::size_t state_bytes(const Preset& preset) {
    return kBytesPerBubble * static_cast<std::size_t>(preset.seeding.bubbles);
}

// Returns the approximate number of frames, from frame 1 on, whose states fit in `bytes` bytes.
// Assumes one state per frame, and one more state after the last frame. The result is at least 1.
int frames_that_fit(const Preset& preset, std::size_t bytes) {
    const std::size_t states = std::max<std::size_t>(2, bytes / (state_bytes(preset) + 1));
    return static_cast<int>(std::min(static_cast<std::size_t>(preset.frames.count), states - 1));
}

}  // namespace

FrameStore::FrameStore(std::size_t bytes) : bytes_(bytes), worker_([this] { work(); }) {}

FrameStore::~FrameStore() {
    stop();
    worker_.join();
}

void FrameStore::stop() {
    const std::scoped_lock lock(mutex_);
    is_stopped_ = true;
    changed_.notify_all();
}

SimulationState FrameStore::want(const Preset& preset, const std::string& page) {
    const std::scoped_lock lock(mutex_);
    return state_of(*want_run(preset, page));
}

SimulatedFrame FrameStore::frame(const Preset& preset,
                                 int number,
                                 NextFrames next_frames,
                                 const std::string& page) {
    std::unique_lock lock(mutex_);
    const RunPointer run = want_run(preset, page);
    if (number > run->frames) {
        throw SimulationFailed(
            fmt::format("frame {} cannot be shown: the studio keeps only the first {} of {} frames "
                        "of this foam in memory; bake the preset to see the others",
                        number,
                        run->frames,
                        preset.frames.count));
    }
    changed_.wait(lock, [&] {
        return is_stopped_ || run->is_dropped() || run->is_finished() || run->has_states(number);
    });
    if (is_stopped_) {
        throw SimulationStopped("the studio ends");
    }
    if (run->is_dropped() && !run->has_states(number)) {
        throw SimulationStopped(run->drop_reason);
    }
    if (!run->has_states(number)) {
        throw SimulationFailed(run->failure);
    }
    const std::map<int, SimulatedFrame> states = run->states_for(preset, number, next_frames);
    lock.unlock();  // `assemble` may take milliseconds (loop.current); other threads need not wait
    SimulatedFrame found;
    assemble(states, preset, {number}, next_frames, [&](const SimulatedFrame& assembled) {
        found = assembled;
    });
    return found;
}

SimulatedFrame FrameStore::draft(const Preset& preset) {
    Preset quick = preset;
    quick.loop = {};
    quick.events.clear();
    quick.frames.count = 1;
    quick.frames.warm_up = 0.0;
    const std::string simulation = simulation_hash(quick);
    {
        const std::scoped_lock lock(mutex_);
        const auto found = std::ranges::find(drafts_, simulation, [](const Draft& draft) {
            return std::string_view(draft.simulation);
        });
        if (found != drafts_.end()) {
            return found->frame;
        }
    }
    SimulatedFrame frame;
    const RunOutcome outcome =
        simulate_frames(quick, 0, {1}, NextFrames::Included, [&](const SimulatedFrame& simulated) {
            frame = simulated;
        });
    if (outcome.status != RunStatus::Complete) {
        throw SimulationFailed(failure_of(outcome));
    }
    const std::scoped_lock lock(mutex_);
    drafts_.push_front({simulation, state_bytes(quick), frame});
    forget_old_drafts();
    return frame;
}

// Forgets the oldest drafts, so that at most kMaxDrafts remain and fit in the memory of drafts. The
// newest draft is kept even if it is too large. Precondition: the mutex is locked.
void FrameStore::forget_old_drafts() {
    std::size_t bytes = 0;
    std::size_t kept = 0;
    for (const Draft& draft : drafts_) {
        bytes += draft.bytes;
        if (kept == kMaxDrafts || (kept > 0 && bytes > bytes_ / kDraftShare)) {
            break;
        }
        ++kept;
    }
    drafts_.resize(kept);
}

FrameSource FrameStore::source(const Preset& preset) {
    std::unique_lock lock(mutex_);
    const std::string simulation = simulation_hash(preset);
    const auto found = std::ranges::find_if(runs_, [&](const RunPointer& run) {
        return run->simulation == simulation && run->frames == preset.frames.count &&
               run->has_states(run->frames);
    });
    if (found == runs_.end()) {
        return {};
    }
    // The simulation ends soon after it has computed its last state.
    const RunPointer run = *found;
    changed_.wait(lock, [&] { return is_stopped_ || run->is_dropped() || run->is_finished(); });
    if (!run->outcome || !run->failure.empty()) {
        return {};
    }
    return [run, preset](const std::vector<int>& numbers,
                         NextFrames next_frames,
                         const FrameVisitor& on_frame,
                         const ProgressCallback&) {
        assemble(run->kept, preset, numbers, next_frames, on_frame);
        return *run->outcome;
    };
}

FrameStore::RunPointer FrameStore::new_run(const Preset& preset,
                                           const std::string& simulation) const {
    const std::vector<int> frames = numbers_to(frames_that_fit(preset, bytes_));
    auto run = std::make_shared<FrameRun>(FrameRun{.preset = preset, .simulation = simulation});
    run->frames = static_cast<int>(frames.size());
    run->states = states_of(preset, frames, NextFrames::Included);
    for (const int frame : frames) {
        run->last_states.push_back(states_of(preset, {frame}, NextFrames::Included).back());
    }
    return run;
}

// Returns the run of the foam of a preset, and makes it the one that the page wants. Runs that no
// page wants any more are stopped. Precondition: the mutex is locked.
FrameStore::RunPointer FrameStore::want_run(const Preset& preset, const std::string& page) {
    const std::string simulation = simulation_hash(preset);
    for (const RunPointer& run : runs_) {
        run->pages.erase(page);
        if (run->pages.empty() && !run->is_finished() && run->simulation != simulation) {
            run->drop_reason = "the page has asked for another foam";
        }
    }
    runs_.remove_if([](const RunPointer& run) { return run->is_dropped(); });
    auto found = std::ranges::find(
        runs_, simulation, [](const RunPointer& run) { return std::string_view(run->simulation); });
    if (found == runs_.end()) {
        runs_.push_front(new_run(preset, simulation));
        found = runs_.begin();
    }
    runs_.splice(runs_.begin(), runs_, found);
    runs_.front()->pages.insert(page);
    forget_old_runs();
    changed_.notify_all();
    return runs_.front();
}

// Forgets runs until at most kMaxRuns remain and fit in the memory. Finished runs are forgotten
// before unfinished runs. In each of these two groups, the run that was wanted longest ago is
// forgotten first. The run that was wanted last is always kept. Precondition: the mutex is locked.
void FrameStore::forget_old_runs() {
    std::vector<RunPointer> order(runs_.begin(), runs_.end());
    std::stable_partition(
        order.begin() + 1, order.end(), [](const RunPointer& run) { return !run->is_finished(); });
    std::size_t bytes = 0;
    std::size_t count = 0;
    for (const RunPointer& run : order) {
        bytes += run->states.size() * state_bytes(run->preset);
        if (++count > 1 && (count > kMaxRuns || bytes > bytes_)) {
            run->drop_reason = "a foam that was asked for later has replaced this one";
        }
    }
    runs_.remove_if([](const RunPointer& run) { return run->is_dropped(); });
}

SimulationState FrameStore::state_of(const FrameRun& run) const {
    using Status = SimulationState::Status;
    SimulationState state{.done = run.complete_frames(),
                          .total = run.frames,
                          .progress = run.progress,
                          .message = run.failure};
    if (!run.failure.empty()) {
        state.status = Status::Failed;
    } else if (run.outcome) {
        state.status = Status::Complete;
        state.closing_error = run.outcome->closing_error;
    }
    return state;
}

// Returns the unfinished run that was wanted last, or nullptr. Precondition: the mutex is locked.
FrameStore::RunPointer FrameStore::next_run() const {
    const auto found =
        std::ranges::find_if(runs_, [](const RunPointer& run) { return !run->is_finished(); });
    return found == runs_.end() ? nullptr : *found;
}

void FrameStore::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return is_stopped_ || next_run() != nullptr; });
        if (is_stopped_) {
            return;
        }
        const RunPointer run = next_run();
        lock.unlock();
        simulate(run);
        lock.lock();
    }
}

// Simulates a run to its end, or until the run is dropped or the store is stopped. A request of
// another page for another foam does not interrupt the run, unless the store cannot keep both runs
// (forget_old_runs). If all did, two pages that ask in turn could interrupt each other forever.
void FrameStore::simulate(const RunPointer& run) {
    const auto finish = [&](std::optional<RunOutcome> outcome, const std::string& failure) {
        const std::scoped_lock lock(mutex_);
        run->outcome = std::move(outcome);
        run->failure = shown_text(failure);
        changed_.notify_all();
    };
    const auto report = [&](const RunProgress& progress) {
        const std::scoped_lock lock(mutex_);
        run->progress = progress;
        if (is_stopped_ || run->is_dropped()) {
            throw Stopped();
        }
    };
    const auto keep = [&](const SimulatedFrame& state) {
        const std::scoped_lock lock(mutex_);
        run->kept.emplace(state.frame->number, state);
        changed_.notify_all();
    };
    try {
        const RunOutcome outcome = simulate_states(run->preset, 0, run->states, keep, report);
        finish(outcome, failure_of(outcome));
    } catch (const Stopped&) {
        return;  // waiting threads see that the store is stopped, or why the run is dropped
    } catch (const std::bad_alloc&) {
        finish({}, "out of memory: use fewer bubbles or fewer frames");
    } catch (const std::exception& error) {
        finish({}, error.what());
    }
}

}  // namespace foam::texgen
