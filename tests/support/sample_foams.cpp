// SPDX-License-Identifier: Apache-2.0

#include "tests/support/sample_foams.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/patch.h"
#include "core/foam/polygon_mesh.h"
#include "core/foam/random.h"
#include "core/foam/seeding.h"

#include <array>
#include <cmath>
#include <numbers>

namespace foam::test {

namespace {

void join(Network& network, HalfEdgeId h, HalfEdgeId next, BubbleId left) {
    network.set_next(h, next);
    network.set_left(h, left);
}

JunctionId add_junction(Foam& foam) {
    foam.positions.push_back(Vec2::Zero());
    return foam.network.add_junction();
}

FilmId add_film(Foam& foam) {
    foam.t1_armed.push_back(1);
    return foam.network.add_film();
}

BubbleId add_bubble(Foam& foam, double pressure) {
    foam.pressures.push_back(pressure);
    foam.target_areas.push_back(1.0);
    foam.identities.push_back(foam.next_identity++);
    return foam.network.add_bubble();
}

}  // namespace

Frame fitted_frame(Foam foam, int width, int height) {
    const double stretch = foam.domain.width / foam.domain.height * height / width;
    foam.domain.height *= stretch;
    for (Vec2& position : foam.positions) {
        position.y() *= stretch;
    }
    return snapshot(foam, 1);
}

Foam bent_foam(int bubbles, double pressure, std::uint64_t seed) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.lloyd_iterations = 3;
    options.seed = seed;
    Foam foam = seed_foam(options);
    Random random(seed);
    for (double& value : foam.pressures) {
        value = pressure * (2.0 * random.uniform() - 1.0);
    }
    return foam;
}

Foam polydisperse_foam(int bubbles, std::uint64_t seed) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.area_ratio = 30.0;
    options.seed = seed;
    Foam foam = seed_foam(options);
    equilibrate(foam, {});
    return foam;
}

Foam patch_foam(int bubbles, std::uint64_t seed, const std::string& wkt) {
    PatchOptions options;
    options.bubbles = bubbles;
    options.seed = seed;
    Foam foam = seed_patch(wkt.empty() ? disc_outline() : outline_from_wkt(wkt), options);
    equilibrate(foam, {});
    return foam;
}

Foam ring_foam() {
    constexpr std::uint32_t kSix = 6;
    PolygonMesh mesh;
    for (const double radius : {1.0, 2.2}) {
        for (std::uint32_t k = 0; k < kSix; ++k) {
            const double angle = std::numbers::pi / 3.0 * k;
            mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    for (std::uint32_t k = 0; k < kSix; ++k) {
        const std::uint32_t next = (k + 1) % kSix;
        mesh.cells.push_back({k, kSix + k, kSix + next, next});
    }
    Foam foam = foam_from_mesh(mesh);
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const double bulge = chord(foam, h).norm() > 1.5 ? 0.7 : 0.3;
        foam.half_angles[film] = foam.network.left(h) == foam.network.ghost() ? -bulge : bulge;
    }
    return foam;
}

Foam circles(const std::vector<LoneBubble>& bubbles) {
    Foam foam;
    foam.network.add_ghost();
    complete_patch(foam);
    foam.lone_bubbles = bubbles;
    return foam;
}

// Three films go from junction 0 to junction 1, in the directions 63, -45 and -153 degrees. At each
// junction, the next side of the bubble is on the next film in clockwise order.
Foam single_bubble() {
    Foam foam;
    const BubbleId bubble = add_bubble(foam, 0.0);
    const std::array<JunctionId, 2> junctions{add_junction(foam), add_junction(foam)};
    foam.positions[junctions[0]] = {0.2, 0.1};
    foam.positions[junctions[1]] = {0.2 + 1.0 / 3.0, 0.1 + 2.0 / 3.0};
    constexpr std::array<LatticeOffset, 3> kOffsets{{{0, 0}, {0, -1}, {-1, -1}}};
    std::array<HalfEdgeId, 3> forward{};
    for (std::size_t k = 0; k < 3; ++k) {
        forward[k] = forward_side(add_film(foam));
        foam.network.set_tail(forward[k], junctions[0]);
        foam.network.set_tail(twin(forward[k]), junctions[1]);
        foam.network.set_offset(forward[k], kOffsets[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t clockwise = (k + 1) % 3;
        join(foam.network, forward[k], twin(forward[clockwise]), bubble);
        join(foam.network, twin(forward[k]), forward[clockwise], bubble);
    }
    foam.network.set_first(bubble, forward[0]);
    foam.network.set_sides(bubble, 6);
    return foam;
}

BubbleId insert_lens(Foam& foam, FilmId film, double part_of_chord) {
    Network& network = foam.network;
    const HalfEdgeId in = forward_side(film);  // afterwards from its old tail to p
    const HalfEdgeId after_in = network.next(in);
    const HalfEdgeId before_back = network.previous(twin(in));
    const JunctionId far_end = network.head(in);
    const Vec2 start = foam.positions[network.tail(in)];
    const Vec2 whole = chord(foam, in);
    const LatticeOffset offset = network.offset(in);
    const BubbleId left = network.left(in);
    const BubbleId right = network.right(in);
    // The films of the lens have half angles of 60 degrees: sin 60 = curvature x chord / 2.
    const double excess = foam.film_tension * std::numbers::sqrt3 / (part_of_chord * whole.norm());
    const BubbleId lens = add_bubble(foam, foam.pressures[left] + excess);
    const JunctionId p = add_junction(foam);
    const JunctionId q = add_junction(foam);
    const HalfEdgeId upper = forward_side(add_film(foam));  // from p to q, as `lower`
    const HalfEdgeId lower = forward_side(add_film(foam));
    const HalfEdgeId out = forward_side(add_film(foam));  // from q to the old head of the film
    network.set_tail(twin(in), p);
    for (const HalfEdgeId h : {upper, lower}) {
        network.set_tail(h, p);
        network.set_tail(twin(h), q);
    }
    network.set_tail(out, q);
    network.set_tail(twin(out), far_end);
    network.set_offset(in, {});
    network.set_offset(out, offset);
    join(network, in, upper, left);
    join(network, upper, out, left);
    join(network, out, after_in, left);
    join(network, before_back, twin(out), right);
    join(network, twin(out), twin(lower), right);
    join(network, twin(lower), twin(in), right);
    join(network, lower, twin(upper), lens);
    join(network, twin(upper), lower, lens);
    network.set_first(lens, lower);
    network.set_sides(lens, 2);
    network.set_sides(left, network.sides(left) + 2);
    network.set_sides(right, network.sides(right) + 2);
    place_junction(foam, p, start + 0.5 * (1.0 - part_of_chord) * whole);
    place_junction(foam, q, start + 0.5 * (1.0 + part_of_chord) * whole);
    return lens;
}

}  // namespace foam::test
