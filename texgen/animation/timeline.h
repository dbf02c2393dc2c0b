#pragma once

#include "core/dynamics/state_change.h"
#include "core/dynamics/target_course.h"
#include "core/foam/foam.h"
#include "core/foam/random.h"
#include "texgen/preset/preset.h"
#include "texgen/raster/coords/raster_grid.h"

#include <map>
#include <optional>
#include <vector>

namespace foam::texgen {

/// A bubble that an event is about, a lone one perhaps.
struct ChosenBubble {
    BubbleIdentity bubble = 0;
    double area = 0.0;  // its target
};

/// Carries out the events of a preset, frame by frame, and the renewal of a flow.
class Timeline {
  public:
    explicit Timeline(const Preset& preset);

    /// Begins what is due on the way to a frame, from the frame before it: chooses bubbles and
    /// makes new ones, small at first, in a foam that is in equilibrium. Returns what is to be
    /// imposed on that way. Frames must come in order, each once. A choice that finds no bubble, a
    /// place outside of a patch, and a new bubble that finds too little gas around it, come to
    /// nothing. In a flow new bubbles make up for those that have vanished.
    StateChange changes_to(int frame, Foam& foam);

    /// What images of a patch show: the places of events are in parts of it. Until it is known, a
    /// foam unit is a pixel.
    void set_view(const View& view) { view_ = view; }

  private:
    // A bubble that is driven while the foam goes to the frames of a span.
    struct Driven {
        FrameSpan frames;
        TargetCourse course;
        bool vanishes = false;
    };
    // An event and the random numbers that are its own.
    struct Entry {
        Event event;
        Random random;
    };

    // How a flow gets new bubbles: on random places of the torus, so that large ones, whose gas
    // they take, give most.
    struct Renewal {
        std::size_t bubbles = 0;  // that there are to be
        int growth = 1;           // frames that new ones take to the mean area
        Random random;
    };

    Vec2 place_of(const Event& event, const Foam& foam) const;
    std::vector<ChosenBubble> choose(const Event& event,
                                     const Foam& foam,
                                     std::size_t turn,
                                     std::size_t count) const;
    void add_motion(const Event& event, int frame, const Foam& foam, StateChange& change) const;
    void begin(Entry& entry, int frame, Foam& foam);
    void begin_collapse(const Event& event, int frame, const Foam& foam);
    void begin_drive(Entry& entry, int frame, const Foam& foam);
    void nucleate(Entry& entry, int frame, Foam& foam);
    void renew(int frame, Foam& foam);
    double first_area(double area) const;
    void grow(const Foam& foam, BubbleId bubble, const FrameSpan& frames, double area);

    TopologyThresholds thresholds_;
    ImageOptions image_;
    View view_;
    std::vector<Entry> entries_;
    std::optional<Renewal> renewal_;
    std::map<BubbleIdentity, Driven> driven_;  // whatever drove a bubble last has it
};

}  // namespace foam::texgen
