#pragma once

#include "core/geometry/domain.h"
#include "core/network/indexed.h"
#include "core/network/live_range.h"

#include <array>
#include <cstddef>
#include <vector>

namespace foam {

/// Who touches whom in a foam whose every junction joins three films, on a torus or in the plane.
///
/// Half-edges go counter-clockwise around the bubble on their left. Each knows the junction at its
/// tail, that bubble, its successor around the bubble, and a lattice offset: the copy of its head's
/// junction, seen from its tail's, lies that many periods away. No coordinates are held here.
///
/// In the plane one more bubble, the ghost, is what lies around the foam and in its holes (paper
/// 4.2): it is on the other side of the outer films. It has an id and a slot, but it is none of
/// `bubbles()`, and as it may have several boundaries, or none, nothing goes around it. Its `sides`
/// are all its films, its `first` any of them.
///
/// A T2 leaves dead slots behind, so that ids stand while a step works; `compact` closes the gaps.
/// Accessors take live ids only, unless said otherwise.
class Network {
  public:
    /// Slots in use or dead: the size of every vector that is indexed by such an id.
    std::size_t junction_slots() const { return outgoing_.size(); }
    std::size_t film_slots() const { return offsets_.size(); }
    std::size_t bubble_slots() const { return first_.size(); }

    std::size_t junction_count() const { return junction_count_; }
    std::size_t film_count() const { return film_count_; }
    std::size_t bubble_count() const { return bubble_count_; }

    /// None on a torus.
    BubbleId ghost() const { return ghost_; }
    /// Whether the film has the ghost on one side. Its other side is never the ghost too.
    bool is_outer(FilmId film) const {
        return ghost_ != kNone<BubbleId> &&
               (left(forward_side(film)) == ghost_ || right(forward_side(film)) == ghost_);
    }

    /// Live ids in increasing order.
    LiveRange<JunctionId> junctions() const { return LiveRange<JunctionId>(junction_live_); }
    LiveRange<FilmId> films() const { return LiveRange<FilmId>(film_live_); }
    LiveRange<BubbleId> bubbles() const { return LiveRange<BubbleId>(bubble_live_); }

    /// Any id. The ghost is live.
    bool is_live(JunctionId junction) const { return junction_live_[index_of(junction)]; }
    bool is_live(FilmId film) const { return film_live_[index_of(film)]; }
    bool is_live(BubbleId bubble) const {
        return bubble_live_[index_of(bubble)] || bubble == ghost_;
    }

    JunctionId tail(HalfEdgeId h) const { return half_edges_[index_of(h)].tail; }
    JunctionId head(HalfEdgeId h) const { return tail(twin(h)); }
    BubbleId left(HalfEdgeId h) const { return half_edges_[index_of(h)].left; }
    BubbleId right(HalfEdgeId h) const { return left(twin(h)); }
    HalfEdgeId next(HalfEdgeId h) const { return half_edges_[index_of(h)].next; }
    HalfEdgeId previous(HalfEdgeId h) const { return twin(next(twin(next(twin(h))))); }
    LatticeOffset offset(HalfEdgeId h) const {
        return is_forward(h) ? offsets_[film_of(h)] : -offsets_[film_of(h)];
    }

    /// One of the half-edges that leave the junction, or that go around the bubble.
    HalfEdgeId outgoing(JunctionId junction) const { return outgoing_[junction]; }
    HalfEdgeId first(BubbleId bubble) const { return first_[bubble]; }
    int sides(BubbleId bubble) const { return sides_[bubble]; }

    /// The half-edges that leave a junction, clockwise from outgoing().
    std::array<HalfEdgeId, 3> leaving(JunctionId junction) const;
    /// The half-edges around a bubble, not the ghost, counter-clockwise from first().
    std::vector<HalfEdgeId> around(BubbleId bubble) const;

    // Building and surgery. They keep no invariant by themselves; `validate` checks them all.
    JunctionId add_junction();
    FilmId add_film();
    BubbleId add_bubble();
    BubbleId add_ghost();  // precondition: there is none
    void set_tail(HalfEdgeId h,
                  JunctionId junction);  // also makes h the junction's outgoing half-edge
    void set_left(HalfEdgeId h, BubbleId bubble) { half_edges_[index_of(h)].left = bubble; }
    void set_next(HalfEdgeId h, HalfEdgeId next) { half_edges_[index_of(h)].next = next; }
    void set_offset(HalfEdgeId h, LatticeOffset offset);
    void set_first(BubbleId bubble, HalfEdgeId h) { first_[bubble] = h; }
    void set_sides(BubbleId bubble, int sides) { sides_[bubble] = sides; }
    void remove(JunctionId junction);
    void remove(FilmId film);
    void remove(BubbleId bubble);

    /// Moves the junction by whole periods: what was its copy at -by becomes the junction itself.
    /// Chords stand if its position moves by -by too.
    void rebase(JunctionId junction, LatticeOffset by);

    /// Old ids of what remains, in the new order, which is the old one without the dead; the ghost
    /// comes last.
    struct Kept {
        std::vector<JunctionId> junctions;
        std::vector<FilmId> films;
        std::vector<BubbleId> bubbles;
    };
    Kept compact();

  private:
    struct HalfEdge {
        JunctionId tail = kNone<JunctionId>;
        BubbleId left = kNone<BubbleId>;
        HalfEdgeId next = kNone<HalfEdgeId>;
    };

    std::vector<HalfEdge> half_edges_;
    Indexed<FilmId, LatticeOffset> offsets_;
    Indexed<JunctionId, HalfEdgeId> outgoing_;
    Indexed<BubbleId, HalfEdgeId> first_;
    Indexed<BubbleId, int> sides_;
    std::vector<bool> junction_live_;
    std::vector<bool> film_live_;
    std::vector<bool> bubble_live_;
    std::size_t junction_count_ = 0;
    std::size_t film_count_ = 0;
    std::size_t bubble_count_ = 0;
    BubbleId ghost_ = kNone<BubbleId>;
};

}  // namespace foam
