// SPDX-License-Identifier: Apache-2.0

#include "core/network/network.h"

#include <cassert>
#include <utility>

namespace foam {

namespace {

// Returns the new id for each old id. The new id of a removed element is kNone.
template <class Id>
Indexed<Id, Id> new_ids(const std::vector<Id>& old_ids, std::size_t slots) {
    Indexed<Id, Id> ids(slots, kNone<Id>);
    for (std::size_t i = 0; i < old_ids.size(); ++i) {
        ids[old_ids[i]] = id_at<Id>(i);
    }
    return ids;
}

}  // namespace

std::array<HalfEdgeId, 3> Network::leaving(JunctionId junction) const {
    const HalfEdgeId a = outgoing(junction);
    const HalfEdgeId b = next(twin(a));
    return {a, b, next(twin(b))};
}

std::vector<HalfEdgeId> Network::around(BubbleId bubble) const {
    assert(bubble != ghost_);
    std::vector<HalfEdgeId> loop;
    loop.reserve(static_cast<std::size_t>(sides(bubble)));
    HalfEdgeId h = first(bubble);
    do {
        loop.push_back(h);
        h = next(h);
    } while (h != first(bubble));
    return loop;
}

JunctionId Network::add_junction() {
    junction_live_.push_back(true);
    ++junction_count_;
    return outgoing_.push_back(kNone<HalfEdgeId>);
}

FilmId Network::add_film() {
    half_edges_.resize(half_edges_.size() + 2);
    film_live_.push_back(true);
    ++film_count_;
    return offsets_.push_back({});
}

BubbleId Network::add_bubble() {
    bubble_live_.push_back(true);
    ++bubble_count_;
    sides_.push_back(0);
    return first_.push_back(kNone<HalfEdgeId>);
}

BubbleId Network::add_ghost() {
    assert(ghost_ == kNone<BubbleId>);
    ghost_ = add_bubble();
    bubble_live_[index_of(ghost_)] = false;
    --bubble_count_;
    return ghost_;
}

void Network::set_tail(HalfEdgeId h, JunctionId junction) {
    half_edges_[index_of(h)].tail = junction;
    outgoing_[junction] = h;
}

void Network::set_offset(HalfEdgeId h, LatticeOffset offset) {
    offsets_[film_of(h)] = is_forward(h) ? offset : -offset;
}

void Network::remove(JunctionId junction) {
    junction_live_[index_of(junction)] = false;
    --junction_count_;
}

void Network::remove(FilmId film) {
    film_live_[index_of(film)] = false;
    --film_count_;
}

void Network::remove(BubbleId bubble) {
    bubble_live_[index_of(bubble)] = false;
    --bubble_count_;
}

void Network::rebase(JunctionId junction, LatticeOffset periods) {
    for (const HalfEdgeId h : leaving(junction)) {
        set_offset(h, offset(h) - periods);
    }
}

bool Network::is_connected_as(const Network& other) const {
    return half_edges_ == other.half_edges_ && outgoing_ == other.outgoing_ &&
           first_ == other.first_ && junction_live_ == other.junction_live_ &&
           film_live_ == other.film_live_ && bubble_live_ == other.bubble_live_ &&
           ghost_ == other.ghost_;
}

Network::OldIds Network::live_ids() const {
    OldIds live{junctions().ids(junction_count()),
                films().ids(film_count()),
                bubbles().ids(bubble_count())};
    if (ghost_ != kNone<BubbleId>) {
        live.bubbles.push_back(ghost_);
    }
    return live;
}

void Network::renumber(const OldIds& order) {
    const auto junction = new_ids(order.junctions, junction_slots());
    const auto film = new_ids(order.films, film_slots());
    const auto bubble = new_ids(order.bubbles, bubble_slots());
    const auto half_edge = [&](HalfEdgeId h) {
        const HalfEdgeId forward = forward_side(film[film_of(h)]);
        return is_forward(h) ? forward : twin(forward);
    };
    Network dense;
    for (std::size_t i = 0; i < order.junctions.size(); ++i) {
        dense.add_junction();
    }
    for (const BubbleId old : order.bubbles) {
        const BubbleId id = old == ghost_ ? dense.add_ghost() : dense.add_bubble();
        dense.set_first(id, sides(old) > 0 ? half_edge(first(old)) : kNone<HalfEdgeId>);
        dense.set_sides(id, sides(old));
    }
    for (const FilmId old : order.films) {
        const FilmId id = dense.add_film();
        dense.offsets_[id] = offsets_[old];
        for (const HalfEdgeId h : {forward_side(old), twin(forward_side(old))}) {
            HalfEdge& target = dense.half_edges_[index_of(half_edge(h))];
            target = {junction[tail(h)], bubble[left(h)], half_edge(next(h))};
        }
    }
    for (const JunctionId old : order.junctions) {
        dense.outgoing_[junction[old]] = half_edge(outgoing(old));
    }
    *this = std::move(dense);
}

bool Network::is_compact() const {
    const bool has_ghost = ghost_ != kNone<BubbleId>;
    return junction_count() == junction_slots() && film_count() == film_slots() &&
           bubble_slots() == bubble_count() + (has_ghost ? 1 : 0) &&
           (!has_ghost || index_of(ghost_) == bubble_count());
}

}  // namespace foam
