#include "texgen/bake/loop_pose.h"

#include "core/dynamics/shear.h"

namespace foam::texgen {

Foam posed(Foam foam, const LoopOptions& loop, double passed) {
    if (loop.kind == LoopKind::Shear) {
        shear(foam, -foam.torus.shear / foam.torus.height);
        foam.torus.shear = 0.0;  // but for rounding it is
    }
    if (loop.drift != std::array{0, 0}) {
        const Vec2 by(passed * loop.drift[0] * foam.torus.width,
                      passed * loop.drift[1] * foam.torus.height);
        for (const JunctionId junction : foam.network.junctions()) {
            place_junction(foam, junction, foam.positions[junction] + by);
        }
    }
    return foam;
}

int shown_frame(int number, const LoopOptions& loop, int count) {
    if (loop.kind != LoopKind::PingPong) {
        return number;
    }
    const int place = (number - 1) % count;
    return 1 + (2 * place <= count ? place : count - place);
}

}  // namespace foam::texgen
