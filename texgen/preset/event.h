#pragma once

#include "core/foam/foam.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace foam::texgen {

enum class EventKind {
    Collapse,  // bubbles vanish on command
    Nucleate,  // new bubbles
    Drive,     // the area of bubbles is given
    Force,     // pushes a part of the foam
    Shear,     // of the whole foam
};

/// Where a new bubble comes to be.
enum class NucleationSite { Junction, Film };

/// How the bubbles of one event share its frames.
enum class EventOrder { AtOnce, InTurn };

/// Where the swings of several bubbles start.
enum class Phases { Same, Random };

/// Frames that show the event at work: on the way to the first it begins, at the last it is done.
struct FrameSpan {
    int first = 0;  // 0: not said
    int last = 0;

    int length() const { return last - first + 1; }
    friend bool operator==(const FrameSpan& a, const FrameSpan& b) = default;
};

/// Something that happens to the foam from outside: one [[event]] of a preset. Which members count
/// depends on the kind; see event_schema.h.
struct Event {
    std::optional<EventKind> kind;              // always there in a checked preset
    FrameSpan frames;                           // or else
    std::optional<std::array<double, 2>> time;  // foam time from and to; both the same: an instant

    // The bubbles, by one of three; a position in parts of the image's width and height.
    std::vector<BubbleIdentity> bubbles;
    std::optional<std::array<double, 2>> at;
    std::vector<int> sides;
    int count = 1;
    EventOrder order = EventOrder::AtOnce;

    NucleationSite on = NucleationSite::Junction;
    double area = 0.5;  // foam units
    int growth = 1;     // frames that a new bubble takes to its area

    double scale = 1.0;  // of the area, reached at the last frame
    double amplitude = 0.0;
    double period = 24.0;  // frames
    double phase = 0.0;    // turns
    Phases phases = Phases::Same;

    double radius = 2.0;                   // foam units
    std::array<double, 2> push{1.0, 0.0};  // foam units, in all

    double strain = 1.0;  // in all, over the frames

    /// How many bubbles it names by one of the three; 0 stands for all.
    std::size_t bubbles_named() const {
        if (!bubbles.empty()) {
            return bubbles.size();
        }
        return sides.empty() ? (at ? 1U : 0U) : static_cast<std::size_t>(count);
    }
};

}  // namespace foam::texgen
