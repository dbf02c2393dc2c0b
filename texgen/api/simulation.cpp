// SPDX-License-Identifier: Apache-2.0

#include "core/library/require.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/api/public_errors.h"
#include "texgen/api/state.h"
#include "texgen/bake/frame_range.h"
#include "texgen/preset/drawn_images.h"

#include <foamtex/texture.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

// A thread simulates the preset and passes its frames to the caller through a queue. The queue is
// bounded, so that memory does not grow with the number of frames.

namespace foamtex {

namespace {

constexpr std::size_t kQueuedFrames = 3;
constexpr std::chrono::milliseconds kPollPeriod{100};

foam::texgen::NextFrames next_frames_of(const foam::texgen::Preset& preset) {
    return foam::texgen::needs_next_frame(preset) ? foam::texgen::NextFrames::Included
                                                  : foam::texgen::NextFrames::Omitted;
}

// The exception that ends the simulation when the caller needs no more frames.
struct Stopped {};

}  // namespace

struct Simulation::Stream {
    Stream(Preset simulation_preset, std::vector<int> numbers, int threads)
        : preset(std::move(simulation_preset)),
          thread([this, numbers = std::move(numbers), threads] { run(numbers, threads); }) {}

    ~Stream() {
        {
            const std::scoped_lock lock(mutex);
            stop_requested = true;
        }
        changed.notify_all();
        thread.join();
    }

    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    // Simulates all frames. Runs on the thread.
    void run(const std::vector<int>& numbers, int threads) {
        std::exception_ptr caught;
        try {
            foam::texgen::with_texture_errors([&] {
                foam::texgen::throw_if_failed(foam::texgen::simulate_frames(
                    preset.state().preset,
                    threads,
                    numbers,
                    next_frames_of(preset.state().preset),
                    [this](const foam::texgen::SimulatedFrame& frame) { add(frame); },
                    [this](const foam::texgen::RunProgress&) { throw_if_stopped(); }));
            });
        } catch (const Stopped&) {
            return;
        } catch (...) {
            caught = std::current_exception();
        }
        {
            const std::scoped_lock lock(mutex);
            error = caught;
            has_ended = true;
        }
        changed.notify_all();
    }

    void add(const foam::texgen::SimulatedFrame& simulated) {
        Frame frame(std::make_shared<const Frame::State>(simulated, preset));
        {
            std::unique_lock lock(mutex);
            changed.wait(lock, [&] { return stop_requested || frames.size() < kQueuedFrames; });
            if (stop_requested) {
                throw Stopped();
            }
            frames.push_back(std::move(frame));
        }
        changed.notify_all();
    }

    void throw_if_stopped() {
        const std::scoped_lock lock(mutex);
        if (stop_requested) {
            throw Stopped();
        }
    }

    std::optional<Frame> next(const std::function<void()>& poll) {
        std::unique_lock lock(mutex);
        while (!changed.wait_for(lock, kPollPeriod, [&] { return has_ended || !frames.empty(); })) {
            if (poll) {
                lock.unlock();
                poll();
                lock.lock();
            }
        }
        if (frames.empty()) {
            if (error) {
                std::rethrow_exception(error);
            }
            return std::nullopt;
        }
        Frame frame = std::move(frames.front());
        frames.pop_front();
        lock.unlock();
        changed.notify_all();
        return frame;
    }

    Preset preset;
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Frame> frames;     // simulated, and not yet taken
    bool has_ended = false;       // true after the last frame, or after an error
    bool stop_requested = false;  // true if the caller needs no more frames
    std::exception_ptr error;     // why the simulation has ended early
    std::thread thread;           // last, because it uses the other members
};

Simulation::Simulation(const Preset& preset, const std::string& frames, int threads)
    : stream_(foam::texgen::with_texture_errors([&] {
          foam::require_threads(threads);
          return std::make_unique<Stream>(
              preset, foam::texgen::frames_or_all(frames, preset.frame_count()), threads);
      })) {}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

std::optional<Frame> Simulation::next(const std::function<void()>& poll) {
    return stream_->next(poll);
}

}  // namespace foamtex
