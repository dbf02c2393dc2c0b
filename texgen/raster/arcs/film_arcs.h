// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "core/parallel/kernel_array.h"
#include "texgen/raster/arcs/pixel_arc.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Eight angles in [-pi, pi], in radians, with their cosines and sines.
struct HalfAngles {
    static constexpr std::size_t kLanes = 8;

    KernelArray<double, kLanes> angle;
    KernelArray<double, kLanes> cosine;
    KernelArray<double, kLanes> sine;
};

/// Computes the cosine and the sine of every angle. Uses only additions, subtractions and
/// multiplications, so that the results have the same bits on every machine. The errors of the
/// results are up to 1e-14.
void find_sines_and_cosines(HalfAngles& half_angles);

/// Returns, in pixels, the arc of the forward side (HalfEdgeId) of every film, from its tail to its
/// head, indexed by film. `scale` is in pixels per foam unit.
std::vector<PixelArc> film_arcs(const Frame& frame, double scale, int threads);

/// Returns the arc of a half-edge, in the direction of the half-edge. `arcs` is a result of
/// film_arcs. The function multiplies by 1 or -1 instead of branching on the direction, because
/// processors could not predict such a branch.
inline PixelArc arc_along(std::span<const PixelArc> arcs, HalfEdgeId side) {
    const PixelArc& forward = arcs[index_of(film_of(side))];
    const double along = static_cast<int>(is_forward(side)) * 2 - 1;
    return {along * forward.chord, forward.cosine, along * forward.sine};
}

}  // namespace foam::texgen
