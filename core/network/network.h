// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/network/indexed.h"
#include "core/network/live_range.h"

#include <array>
#include <cstddef>
#include <vector>

namespace foam {

/// The topology of a foam in which every junction joins three films, on a torus or in the plane: a
/// half-edge data structure without coordinates.
///
/// Half-edges run counter-clockwise around the bubble on their left. Each half-edge stores the
/// junction at its tail, the bubble on its left, and its successor around this bubble. Each film
/// stores a lattice offset. A film starts at the junction at its tail. On a torus it may end at a
/// periodic copy of the junction at its head. The lattice offset of the film is the translation
/// from this junction to the copy.
///
/// In the plane one more bubble, the ghost, represents the space around the foam and in its holes
/// (paper 4.2). A film with the ghost on one side is an outer film. The ghost has an id and a slot,
/// but is not one of `bubbles()`. It may have several boundaries, or none, so a traversal by next()
/// does not always visit all its half-edges. `sides(ghost())` is the number of its half-edges in
/// all boundaries. `first(ghost())` is any of its half-edges, and is not valid if the ghost has
/// no half-edge.
///
/// A removed element leaves a dead slot behind, so that the ids of other elements stay valid during
/// a time step; `renumber` removes dead slots. Accessors take live ids only, unless stated
/// otherwise.
class Network {
  public:
    // Return the number of slots of one kind of elements, live and dead. A vector that is indexed
    // by the ids of these elements has this size.
    std::size_t junction_slots() const { return outgoing_.size(); }
    std::size_t film_slots() const { return offsets_.size(); }
    std::size_t bubble_slots() const { return first_.size(); }

    // Return the number of live elements. The ghost is not counted.
    std::size_t junction_count() const { return junction_count_; }
    std::size_t film_count() const { return film_count_; }
    std::size_t bubble_count() const { return bubble_count_; }

    /// Returns the ghost, or kNone if the network has no ghost, as on a torus.
    BubbleId ghost() const { return ghost_; }
    /// Returns true if the film has the ghost on one side. No film has the ghost on both sides.
    bool is_outer(FilmId film) const {
        return ghost_ != kNone<BubbleId> &&
               (left(forward_side(film)) == ghost_ || right(forward_side(film)) == ghost_);
    }

    // Return the live ids in increasing order, without the ghost.
    LiveRange<JunctionId> junctions() const { return LiveRange<JunctionId>(junction_live_); }
    LiveRange<FilmId> films() const { return LiveRange<FilmId>(film_live_); }
    LiveRange<BubbleId> bubbles() const { return LiveRange<BubbleId>(bubble_live_); }

    // Return true if the element is live. The ghost is live. Precondition: the id has a slot.
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
    /// Returns the predecessor of h around the bubble on its left, found by circulating around the
    /// tail of h.
    HalfEdgeId previous(HalfEdgeId h) const { return twin(next(twin(next(twin(h))))); }
    /// Returns the lattice offset of h: the translation from the junction head(h) to the copy at
    /// which h ends. The twin has the opposite offset.
    LatticeOffset offset(HalfEdgeId h) const {
        return is_forward(h) ? offsets_[film_of(h)] : -offsets_[film_of(h)];
    }

    /// Returns one of the half-edges that leave the junction.
    HalfEdgeId outgoing(JunctionId junction) const { return outgoing_[junction]; }
    /// Returns the half-edge with which around() begins; for the ghost, any of its half-edges.
    HalfEdgeId first(BubbleId bubble) const { return first_[bubble]; }
    /// Returns the number of half-edges around the bubble.
    int sides(BubbleId bubble) const { return sides_[bubble]; }

    /// Returns the half-edges that leave a junction, clockwise from outgoing().
    std::array<HalfEdgeId, 3> leaving(JunctionId junction) const;
    /// Returns the half-edges around a bubble, counter-clockwise from first(). Precondition: the
    /// bubble is not the ghost.
    std::vector<HalfEdgeId> around(BubbleId bubble) const;

    // Functions for building and changing the network. They do not maintain the invariants;
    // find_fault (validate.h) checks the invariants. The functions add_... return the id of the new
    // element, which is not connected to any other element yet.
    JunctionId add_junction();
    FilmId add_film();
    BubbleId add_bubble();
    BubbleId add_ghost();  // precondition: the network has no ghost
    void set_tail(HalfEdgeId h,
                  JunctionId junction);  // also makes h the junction's outgoing half-edge
    void set_left(HalfEdgeId h, BubbleId bubble) { half_edges_[index_of(h)].left = bubble; }
    void set_next(HalfEdgeId h, HalfEdgeId next) { half_edges_[index_of(h)].next = next; }
    void set_offset(HalfEdgeId h, LatticeOffset offset);
    void set_first(BubbleId bubble, HalfEdgeId h) { first_[bubble] = h; }
    void set_sides(BubbleId bubble, int sides) { sides_[bubble] = sides; }
    void remove(JunctionId junction);
    void remove(FilmId film);
    void remove(BubbleId bubble);  // precondition: the bubble is not the ghost

    /// Adapts the lattice offsets of the films of a junction to a move of the junction by whole
    /// periods. Subtracts `periods` from the offset of each half-edge that leaves the junction.
    /// Changes nothing else. The caller must also subtract the translation of `periods` from the
    /// position of the junction; the chords of the films are then unchanged.
    void rebase(JunctionId junction, LatticeOffset periods);

    /// Returns true if the networks have the same slots, live elements and connections, and if
    /// first() of each bubble and outgoing() of each junction are the same. The lattice offsets may
    /// differ.
    bool is_connected_as(const Network& other) const;

    /// The old ids of the elements in a new order: the index of an old id in its vector is the new
    /// id. The ghost, if any, is the last bubble.
    struct OldIds {
        std::vector<JunctionId> junctions;
        std::vector<FilmId> films;
        std::vector<BubbleId> bubbles;
    };
    /// Returns the ids of all live elements, in increasing order except for the ghost.
    OldIds live_ids() const;
    /// Renumbers all elements, and removes the dead slots. Precondition: `order` contains each live
    /// element and the ghost once, the ghost as the last bubble.
    void renumber(const OldIds& order);
    /// Returns true if there are no dead slots and the ghost, if any, is the last bubble. Calling
    /// renumber(live_ids()) would then change nothing.
    bool is_compact() const;

  private:
    struct HalfEdge {
        JunctionId tail = kNone<JunctionId>;
        BubbleId left = kNone<BubbleId>;
        HalfEdgeId next = kNone<HalfEdgeId>;

        friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
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
