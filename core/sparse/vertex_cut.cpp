// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/vertex_cut.h"

#include <algorithm>
#include <limits>

namespace foam {

// Dinic's maximum flow algorithm alternates two steps. The first finds the levels of the vertices,
// up to the level of the sink, by breadth-first search. The second pushes a blocking flow along
// arcs from each level to the next. When the sink is unreachable, the cut consists of the nodes
// whose entry vertex can be reached and whose exit vertex cannot be reached (max-flow min-cut
// theorem).

namespace {

constexpr std::uint32_t kNoArc = std::numeric_limits<std::uint32_t>::max();
constexpr int kUnlimited = std::numeric_limits<int>::max() / 2;
constexpr std::size_t kSource = 0;
constexpr std::size_t kSink = 1;

}  // namespace

void VertexCut::reset(std::size_t nodes) {
    nodes_ = nodes;
    arcs_.clear();
    first_.assign(2 * nodes + 2, kNoArc);
}

void VertexCut::set_weight(std::size_t node, int weight) {
    add_arc(entry(node), exit(node), weight);
}

void VertexCut::make_source(std::size_t node) {
    add_arc(kSource, entry(node), kUnlimited);
}

void VertexCut::make_sink(std::size_t node) {
    add_arc(exit(node), kSink, kUnlimited);
}

void VertexCut::connect(std::size_t from, std::size_t to) {
    add_arc(exit(from), entry(to), kUnlimited);
}

void VertexCut::add_arc(std::size_t from, std::size_t to, int capacity) {
    const auto arc = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back({static_cast<std::uint32_t>(to), first_[from], capacity});
    arcs_.push_back({static_cast<std::uint32_t>(from), first_[to], 0});
    first_[from] = arc;
    first_[to] = arc + 1;
}

// Finds the level of each vertex, the number of steps from the source along arcs with free
// capacity, by breadth-first search. Stops when the sink is found; the levels of vertices that were
// not found until then are -1. Returns false if the sink is unreachable.
bool VertexCut::find_levels() {
    levels_.assign(first_.size(), -1);
    queue_.assign(1, static_cast<std::uint32_t>(kSource));
    levels_[kSource] = 0;
    for (std::size_t k = 0; k < queue_.size() && levels_[kSink] < 0; ++k) {
        const std::uint32_t vertex = queue_[k];
        for (std::uint32_t arc = first_[vertex]; arc != kNoArc; arc = arcs_[arc].next) {
            const std::uint32_t to = arcs_[arc].to;
            if (arcs_[arc].capacity > 0 && levels_[to] < 0) {
                levels_[to] = levels_[vertex] + 1;
                queue_.push_back(to);
            }
        }
    }
    return levels_[kSink] >= 0;
}

// Pushes at most `amount` of flow from a vertex to the sink, along arcs that lead from one level to
// the next. Returns the amount that reached the sink.
int VertexCut::push(std::size_t vertex, int amount) {
    if (vertex == kSink) {
        return amount;
    }
    int pushed = 0;
    for (std::uint32_t& arc = untried_[vertex]; arc != kNoArc; arc = arcs_[arc].next) {
        Arc& out = arcs_[arc];
        if (out.capacity > 0 && levels_[out.to] == levels_[vertex] + 1) {
            const int through = push(out.to, std::min(amount - pushed, out.capacity));
            out.capacity -= through;
            arcs_[arc ^ 1U].capacity += through;
            pushed += through;
        }
        if (pushed == amount) {
            break;
        }
    }
    return pushed;
}

const std::vector<CutSide>& VertexCut::solve() {
    while (find_levels()) {
        untried_ = first_;
        push(kSource, kUnlimited);
    }
    sides_.assign(nodes_, CutSide::Sink);
    for (std::size_t node = 0; node < nodes_; ++node) {
        if (levels_[exit(node)] >= 0) {
            sides_[node] = CutSide::Source;
        } else if (levels_[entry(node)] >= 0) {
            sides_[node] = CutSide::Cut;
        }
    }
    return sides_;
}

}  // namespace foam
