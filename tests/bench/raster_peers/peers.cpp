// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/peers.h"

namespace foam::bench {

std::vector<Painter> painters([[maybe_unused]] int side) {
    std::vector<Painter> all;
#ifdef FOAMTEX_PEER_CAIRO
    all = cairo_painters(side);
#endif
#ifdef FOAMTEX_PEER_AGG
    all.push_back(agg_painter(side));
#endif
    return all;
}

std::vector<DistanceTransform> distance_transforms([[maybe_unused]] int side) {
    std::vector<DistanceTransform> all;
#ifdef FOAMTEX_PEER_OPENCV
    all.push_back(opencv_transform(side));
#endif
    return all;
}

}  // namespace foam::bench
