#include "texgen/bake/simulate_frames.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

// A frame of the animation, and where the simulation must have come to hand it out.
struct Request {
    int number = 0;
    int shown = 0;  // the frame of the simulation that it shows
    int next = 0;   // the one that comes after it, where asked for
    int last() const { return std::max(shown, next); }
};

class Run {
  public:
    Run(Simulation& simulation, NextFrames next_frames)
        : simulation_(simulation), hands_out_next_(next_frames == NextFrames::HandedOut) {}

    bool hand_out(const std::vector<int>& numbers, const FrameVisitor& on_frame) {
        const std::vector<Request> requests = in_order(numbers);
        for (const Request& request : requests) {
            for (const int number : {std::min(request.shown, request.next), request.last()}) {
                if (!make(number)) {
                    return false;
                }
            }
            on_frame(answer(request));
        }
        return true;
    }

  private:
    std::vector<Request> in_order(const std::vector<int>& numbers) const {
        std::vector<Request> requests;
        for (const int number : numbers) {
            const int shown = simulation_.shown(number);
            requests.push_back(
                {number, shown, hands_out_next_ ? simulation_.shown(number + 1) : shown});
        }
        std::sort(requests.begin(), requests.end(), [](const Request& a, const Request& b) {
            return std::pair(a.last(), a.number) < std::pair(b.last(), b.number);
        });
        return requests;
    }

    // Requests are in such an order that a frame is never more than one behind the simulation.
    bool make(int number) {
        while (simulation_.number() < number) {
            if (!advance()) {
                return false;
            }
        }
        if (!made_.contains(number)) {
            std::erase_if(made_, [&](const auto& entry) { return entry.first < number - 1; });
            made_[number] = {std::make_shared<const Frame>(simulation_.frame()),
                             total_,
                             std::make_shared<const FoamRecord>(simulation_.record()),
                             nullptr,
                             {},
                             {}};
        }
        return true;
    }

    bool advance() {
        const Clock::time_point begin = Clock::now();
        const bool found = simulation_.advance();
        const EquilibriumSummary& equilibrium = simulation_.equilibrium();
        total_.t1 += equilibrium.t1;
        total_.t2 += equilibrium.t2;
        total_.area_error = equilibrium.area_error;
        total_.angle_error = equilibrium.angle_error;
        total_.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        return found;
    }

    SimulatedFrame answer(const Request& request) {
        SimulatedFrame answer = made_.at(request.shown);
        answer.effort = effort_since_last(answer.effort);
        answer.view = simulation_.view();
        answer.closing_error = simulation_.closing_error();
        if (request.number != request.shown) {
            Frame renumbered = *answer.frame;
            renumbered.number = request.number;
            answer.frame = std::make_shared<const Frame>(std::move(renumbered));
        }
        if (hands_out_next_) {
            answer.next = made_.at(request.next).frame;
        }
        return answer;
    }

    // Nothing more where an earlier frame is shown again.
    FrameEffort effort_since_last(const FrameEffort& total) {
        FrameEffort effort = total;
        if (total.seconds < handed_out_.seconds) {
            effort.t1 = effort.t2 = 0;
            effort.seconds = 0.0;
            return effort;
        }
        effort.t1 -= handed_out_.t1;
        effort.t2 -= handed_out_.t2;
        effort.seconds -= handed_out_.seconds;
        handed_out_ = total;
        return effort;
    }

    Simulation& simulation_;
    bool hands_out_next_;
    FrameEffort total_;       // from the seed on
    FrameEffort handed_out_;  // of it, so far
    // By the simulation's numbers; with totals as their efforts.
    std::map<int, SimulatedFrame> made_;
};

RunOutcome outcome_of(const Simulation& simulation, bool complete) {
    RunOutcome outcome{RunStatus::Complete, 0, simulation.closing_error()};
    if (!complete) {
        outcome.status =
            simulation.equilibrium().converged() ? RunStatus::OpenLoop : RunStatus::NoEquilibrium;
        outcome.failed_frame = simulation.number();
    }
    return outcome;
}

}  // namespace

FrameSource simulation_of(const Preset& preset, int threads) {
    return
        [preset, threads](
            const std::vector<int>& numbers, NextFrames next_frames, const FrameVisitor& on_frame) {
            Simulation simulation(preset, threads);
            return simulate_frames(simulation, numbers, next_frames, on_frame);
        };
}

RunOutcome simulate_frames(Simulation& simulation,
                           const std::vector<int>& numbers,
                           NextFrames next_frames,
                           const FrameVisitor& on_frame) {
    const bool complete = Run(simulation, next_frames).hand_out(numbers, on_frame);
    return outcome_of(simulation, complete);
}

}  // namespace foam::texgen
