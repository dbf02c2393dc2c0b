// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/event_context.h"

namespace foam::texgen {

Vec2 point_in_view(const View& view, const Vec2& size, const std::array<double, 2>& position) {
    const Vec2 from_middle(position[0] - 0.5, position[1] - 0.5);
    return view.center + from_middle.cwiseProduct(size) / view.pixels_per_unit;
}

Vec2 EventContext::point_at(const std::array<double, 2>& position) const {
    const Domain& domain = foam.domain;
    return domain.is_plane() ? point_in_view(view, image_size, position)
                             : Vec2(position[0] * domain.width, position[1] * domain.height);
}

}  // namespace foam::texgen
