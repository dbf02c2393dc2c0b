#pragma once

namespace foam::texgen {

/// From 0 to 1 where `passed` is, level at both ends.
template <class Number>
Number smooth_step(Number passed) {
    return passed * passed * (Number{3} - Number{2} * passed);
}

}  // namespace foam::texgen
