#include "texgen/bake/simulate_frames.h"

#include <algorithm>
#include <chrono>

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

}  // namespace

bool simulate_frames(Simulation& simulation,
                     std::vector<int> numbers,
                     const FrameVisitor& on_frame) {
    std::sort(numbers.begin(), numbers.end());
    for (const int number : numbers) {
        FrameEffort effort;
        while (simulation.number() < number) {
            if (!advance(simulation, effort)) {
                return false;
            }
        }
        on_frame(std::make_shared<const Frame>(simulation.frame()), effort);
    }
    return true;
}

}  // namespace foam::texgen
