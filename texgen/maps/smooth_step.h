#pragma once

namespace foam::texgen {

/// Returns a smooth step from 0 to 1 as `passed` goes from 0 to 1, level at both ends.
template <class Number>
Number smooth_step(Number passed) {
    return passed * passed * (Number{3} - Number{2} * passed);
}

}  // namespace foam::texgen
