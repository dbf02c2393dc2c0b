#include "texgen/bake/simulate_frames.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

bool advance(Simulation& simulation, FrameEffort& effort) {
    const Clock::time_point begin = Clock::now();
    const bool found = simulation.advance();
    const EquilibriumSummary& equilibrium = simulation.equilibrium();
    effort.t1 += equilibrium.t1;
    effort.t2 += equilibrium.t2;
    effort.area_error = equilibrium.area_error;
    effort.angle_error = equilibrium.angle_error;
    effort.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
    return found;
}

bool advance_to(int number, Simulation& simulation, FrameEffort& effort) {
    while (simulation.number() < number) {
        if (!advance(simulation, effort)) {
            return false;
        }
    }
    return true;
}

std::shared_ptr<const Frame> frame_of(const Simulation& simulation) {
    return std::make_shared<const Frame>(simulation.frame());
}

}  // namespace

bool simulate_frames(Simulation& simulation,
                     std::vector<int> numbers,
                     NextFrames next_frames,
                     const FrameVisitor& on_frame) {
    std::sort(numbers.begin(), numbers.end());
    FrameEffort effort;
    SimulatedFrame shown;
    for (const int number : numbers) {
        if (!advance_to(number, simulation, effort)) {
            return false;
        }
        const bool known = shown.next && shown.next->number == number;
        shown.frame = known ? shown.next : frame_of(simulation);
        shown.record = std::make_shared<const FoamRecord>(simulation.record());
        shown.effort = std::exchange(effort, {});
        if (next_frames == NextFrames::HandedOut) {
            if (!advance_to(number + 1, simulation, effort)) {
                return false;
            }
            shown.next = frame_of(simulation);
        }
        on_frame(shown);
    }
    return true;
}

}  // namespace foam::texgen
