#pragma once

namespace foam {

/// How the target area of a driven bubble runs while it is driven: a ramp, times a swing (E9).
struct TargetCourse {
    double from = 1.0;       // area at the start, foam units
    double to = 1.0;         // area at the end, without the swing
    double amplitude = 0.0;  // of the swing, a part of the area, below 1
    double swings = 0.0;     // from start to end
    double phase = 0.0;      // of the swing at the start, in turns
};

/// (from + (to - from) t) (1 + amplitude sin(2 pi (swings t + phase))) for the passed part t of the
/// time, from 0 to 1.
double target_at(const TargetCourse& course, double passed);

}  // namespace foam
