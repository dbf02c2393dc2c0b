// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/separator_refinement.h"

#include <algorithm>
#include <cstdlib>

namespace foam {

// The method of Fiduccia and Mattheyses (1982), adapted to vertex separators. The nodes of the
// separator have the zone Zone::Outside. A move takes a node from the separator into one zone, and
// the node's neighbors in the other zone into the separator. The gain of a move is the weight that
// the separator loses. A sweep makes one move after another into the same zone. Each time, it takes
// the move with the largest gain from a priority queue. When the gain of a node changes, a move
// with the new gain is added to the queue. A move is outdated if its node has left the separator or
// has another gain now. Outdated moves are removed when they reach the top of the queue. Changes
// are recorded so that the best separator of a sweep can be restored.

namespace {

constexpr int kMaxSweeps = 20;

// A sweep ends at the latest when it has made a certain number of moves since it found its best
// separator. The move that found this separator counts as the first of these moves. Their number is
// kMovesWithoutProgressPerNode times the number of nodes of the separator at the start of the
// sweep, but at most kMaxMovesWithoutProgress.
constexpr std::size_t kMovesWithoutProgressPerNode = 4;
constexpr std::size_t kMaxMovesWithoutProgress = 1000;

}  // namespace

SeparatorRefinement::SeparatorRefinement(const WeightedGraph& graph,
                                         int max_weight,
                                         std::span<Zone> zones)
    : graph_(graph), max_weight_(max_weight), zones_(zones), pulled_weights_(graph.size()) {
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        weight(zones[node]) += graph.weights[node];
        if (zones[node] == Zone::Outside) {
            separator_.push_back(node);
        }
    }
}

std::pair<int, int> SeparatorRefinement::cost() const {
    const auto [separator, low, high] = weights_;
    return {separator, std::abs(low - high)};
}

void SeparatorRefinement::run() {
    Zone into = weight(Zone::Low) < weight(Zone::High) ? Zone::Low : Zone::High;
    int sweeps_without_progress = 0;
    for (int sweeps = 0; sweeps < kMaxSweeps && sweeps_without_progress < 2; ++sweeps) {
        sweeps_without_progress = sweep(into) ? 0 : sweeps_without_progress + 1;
        into = opposite(into);
    }
}

// Moves the separator through the zone opposite to `into` and restores the best separator of the
// sweep. Returns true if the best separator is lighter than the separator before the sweep, or has
// the same weight but better balanced zones.
bool SeparatorRefinement::sweep(Zone into) {
    start_sweep(into);
    const std::pair<int, int> first_cost = cost();
    std::pair<int, int> best_cost = first_cost;
    std::size_t best_changes = 0;
    const std::size_t max_moves_without_progress =
        std::min(kMovesWithoutProgressPerNode * separator_.size(), kMaxMovesWithoutProgress);
    for (std::size_t moves_without_progress = 0;
         moves_without_progress < max_moves_without_progress && make_best_move(into);
         ++moves_without_progress) {
        if (cost() < best_cost) {
            best_cost = cost();
            best_changes = changes_.size();
            moves_without_progress = 0;
        }
    }
    undo_changes_from(best_changes);
    return best_cost < first_cost;
}

void SeparatorRefinement::start_sweep(Zone into) {
    changes_.clear();
    moves_ = {};
    std::erase_if(separator_, [this](std::uint32_t node) { return zones_[node] != Zone::Outside; });
    std::sort(separator_.begin(), separator_.end());
    separator_.erase(std::unique(separator_.begin(), separator_.end()), separator_.end());
    for (const std::uint32_t node : separator_) {
        pulled_weights_[node] = weight_of_neighbors(node, opposite(into));
        add_move(node);
    }
}

// Makes the move with the largest gain. Returns false and makes no move if no move is left, or if
// this move would make the zone `into` too heavy.
bool SeparatorRefinement::make_best_move(Zone into) {
    while (!moves_.empty() && (zones_[moves_.top().node] != Zone::Outside ||
                               moves_.top().gain != gain(moves_.top().node))) {
        moves_.pop();
    }
    if (moves_.empty()) {
        return false;
    }
    const std::uint32_t node = moves_.top().node;
    if (weight(into) + graph_.weights[node] > max_weight_) {
        return false;
    }
    change(node, into);
    for (const WeightedGraph::Edge& edge : graph_.edges_of(node)) {
        if (zones_[edge.to] == opposite(into)) {
            pull_into_separator(edge.to, opposite(into));
        }
    }
    return true;
}

void SeparatorRefinement::pull_into_separator(std::uint32_t node, Zone from) {
    change(node, Zone::Outside);
    separator_.push_back(node);
    pulled_weights_[node] = weight_of_neighbors(node, from);
    add_move(node);
    for (const WeightedGraph::Edge& edge : graph_.edges_of(node)) {
        if (zones_[edge.to] == Zone::Outside) {
            pulled_weights_[edge.to] -= graph_.weights[node];
            add_move(edge.to);
        }
    }
}

void SeparatorRefinement::add_move(std::uint32_t node) {
    moves_.push({gain(node), node});
}

void SeparatorRefinement::change(std::uint32_t node, Zone zone) {
    changes_.push_back({node, zones_[node]});
    weight(zones_[node]) -= graph_.weights[node];
    weight(zone) += graph_.weights[node];
    zones_[node] = zone;
}

// Undoes the changes of this sweep from the index `first` on.
void SeparatorRefinement::undo_changes_from(std::size_t first) {
    for (; changes_.size() > first; changes_.pop_back()) {
        const auto [node, before] = changes_.back();
        weight(zones_[node]) -= graph_.weights[node];
        weight(before) += graph_.weights[node];
        zones_[node] = before;
        if (before == Zone::Outside) {
            separator_.push_back(node);
        }
    }
}

int SeparatorRefinement::weight_of_neighbors(std::uint32_t node, Zone zone) const {
    int sum = 0;
    for (const WeightedGraph::Edge& edge : graph_.edges_of(node)) {
        sum += zones_[edge.to] == zone ? graph_.weights[edge.to] : 0;
    }
    return sum;
}

}  // namespace foam
