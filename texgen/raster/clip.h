#pragma once

#include "core/geometry/vec2.h"

#include <vector>

namespace foam::texgen {

/// A closed chain of straight edges without what lies outside of a box: the rest is joined along
/// the box's border. An edge is cut at the same points in both directions, so that two chains that
/// share it still do.
void clip_to_box(std::vector<Vec2>& chain, const Vec2& low, const Vec2& high);

}  // namespace foam::texgen
