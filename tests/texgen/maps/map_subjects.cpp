// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/maps/map_subjects.h"

#include "core/dynamics/step.h"
#include "tests/support/sample_foams.h"
#include "texgen/maps/cross_fade.h"

#include <algorithm>
#include <array>
#include <string>

namespace foam::texgen::test {

namespace {

constexpr double kTime = 2.0;
constexpr std::size_t kMaxIdentities = 1000;

MapSubject subject_of(Foam foam) {
    MapSubject subject;
    subject.frame = snapshot(foam, 1);
    subject.record.first_pressures =
        pressures_of(present_values(subject.frame), PressureUnit::Current);
    std::sort(subject.record.first_pressures.begin(), subject.record.first_pressures.end());
    for (std::size_t k = 0; k < kMaxIdentities; ++k) {
        subject.record.births.push_back(-2.0 * static_cast<double>(k % 25));
    }
    subject.record.changes.assign(kMaxIdentities, -1.5);
    subject.record.events = {{TopologyEventKind::T1, 1, {0.3, 0.2}},
                             {TopologyEventKind::T2, 0, {2.5, 2.9}},
                             {TopologyEventKind::Birth, -6, {0.5, 0.6}}};
    step(foam, kTime, {});
    subject.next = snapshot(foam, 2);
    return subject;
}

Foam patch_with_a_lone_bubble() {
    Foam foam =
        foam::test::patch_foam(30, 3, "POLYGON((0 0, 6 0, 6 6, 0 6), (2 2, 2 5, 5 5, 5 2))");
    foam.lone_bubbles.push_back({900, {-4.2, -4.2}, 1.5});
    return foam;
}

}  // namespace

const MapSubject& torus_subject() {
    static const MapSubject subject = subject_of(foam::test::polydisperse_foam(24, 5));
    return subject;
}

const MapSubject& patch_subject() {
    static const MapSubject subject = subject_of(patch_with_a_lone_bubble());
    return subject;
}

RasterGrid torus_grid(int size, int shift_x, int shift_y) {
    return {size, size, shift_x, shift_y};
}

RasterGrid patch_grid(int size) {
    return {size, size, 0, 0, View{Vec2::Zero(), size / 12.0}};
}

MapImage draw(std::string_view map,
              const MapSubject& subject,
              const RasterGrid& grid,
              int threads,
              const MapOptions& options) {
    FrameInput input = subject.input();
    const std::array names{std::string(map)};
    input.distance = distance_needs(names, options);
    ShownLayers shown{{input, grid, threads}};
    return texgen::draw(find_map(map), shown, options);
}

}  // namespace foam::texgen::test
