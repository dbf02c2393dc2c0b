// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/part_divider.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace foam {

// Nested dissection keeps the factor L small, because no entry of L couples the two sides of a
// separator. The method is from A. George, Nested dissection of a regular finite element mesh, SIAM
// Journal on Numerical Analysis 10, 1973. It is implemented as a recursion on ranges of the order
// of elimination. The nodes of a range form a subgraph. PartDivider assigns the nodes of a range to
// two zones, Low and High, and a separator. The range is then sorted: first the nodes of Low, then
// the nodes of High, then the separator. The two zones are dissected one after the other, or by
// different threads if the range is large. Each leaf and each separator becomes a DissectionPart;
// these parts are collected in postorder.
//
// All nodes are in descending order at first, and sorting by zone keeps the order of the nodes of a
// zone. The nodes of a DissectionPart are therefore in descending order, too.

namespace {

// A range whose nodes have fewer rows than this in total (SolverNode::rows) is dissected by one
// thread, since a second thread would save next to nothing.
constexpr int kMinParallelDissectionRows = 2000;

using Nodes = std::span<std::uint32_t>;

// Working memory with one element per node.
struct NodeMemory {
    std::vector<std::uint32_t> order;
    DivisionMemory division;

    explicit NodeMemory(std::size_t nodes) : order(nodes), division(nodes) {
        std::iota(order.rbegin(), order.rend(), 0U);
    }
};

class Dissector {
  public:
    Dissector(const NodeGraph& graph,
              std::span<const SolverNode> nodes,
              const Domain& domain,
              const DissectionOptions& options,
              NodeMemory& memory)
        : nodes_(nodes),
          options_(options),
          memory_(memory),
          divider_(graph, nodes, domain, options, memory.division) {}

    // Dissects all nodes. The last element of `parts` is then the root of the tree.
    void dissect_all(int threads) {
        dissect({0, memory_.order.size(), divider_.box_of_all()}, threads);
    }

    std::vector<DissectionPart> parts;

  private:
    // A range of the order. `box` is a box around the nodes of the range. If `box` has no value,
    // the nodes are divided by the edges of the graph alone.
    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::optional<PartBox> box;
    };
    using PartIndices = std::pair<std::size_t, std::size_t>;

    // Dissects a range: appends its tree to `parts`. Returns the index of the tree's root.
    std::size_t dissect(const Range& range, int threads) {
        const auto [begin, end, box] = range;
        const Nodes part = Nodes(memory_.order).subspan(begin, end - begin);
        const int rows = rows_of(part);
        if (rows <= options_.leaf_rows) {
            return add_part({begin, end});
        }
        const ZoneBoxes boxes = divider_.divide(part, rows, box);
        const auto [low, high] = sort_by_zone(part);
        if (low == 0 || high == 0) {
            return add_part({begin, end});
        }
        const Range low_range{begin, begin + low, boxes.low};
        const Range high_range{begin + low, begin + low + high, boxes.high};
        const auto [left, right] = threads > 1 && rows >= kMinParallelDissectionRows
                                       ? dissect_concurrently(low_range, high_range, threads)
                                       : dissect_sequentially(low_range, high_range);
        return add_part({begin + low + high, end, left, right});
    }

    PartIndices dissect_sequentially(const Range& low, const Range& high) {
        const std::size_t left = dissect(low, 1);
        return {left, dissect(high, 1)};
    }

    PartIndices dissect_concurrently(const Range& low, const Range& high, int threads) {
        Dissector other(*this);
        other.parts.clear();
        const int half = threads / 2;
        parallel_for(2, 2, [&](int which) {
            if (which == 0) {
                dissect(low, half);
            } else {
                other.dissect(high, threads - half);
            }
        });
        const std::size_t left = parts.size() - 1;
        append(other.parts);
        return {left, parts.size() - 1};
    }

    void append(const std::vector<DissectionPart>& others) {
        const std::size_t shift = parts.size();
        for (DissectionPart part : others) {
            if (!part.is_leaf()) {
                part.left += shift;
                part.right += shift;
            }
            parts.push_back(part);
        }
    }

    std::size_t add_part(const DissectionPart& part) {
        parts.push_back(part);
        return parts.size() - 1;
    }

    int rows_of(Nodes part) const {
        int rows = 0;
        for (const std::uint32_t node : part) {
            rows += nodes_[node].rows;
        }
        return rows;
    }

    // Sorts the nodes of `part`: first those of Low, then those of High, then the separator. Resets
    // the zones of all these nodes to Outside. Returns how many nodes were in Low and in High.
    std::pair<std::size_t, std::size_t> sort_by_zone(Nodes part) {
        const auto is_in = [this](Zone zone) {
            return
                [this, zone](std::uint32_t node) { return memory_.division.zones[node] == zone; };
        };
        const auto low_end = std::stable_partition(part.begin(), part.end(), is_in(Zone::Low));
        const auto high_end = std::stable_partition(low_end, part.end(), is_in(Zone::High));
        for (const std::uint32_t node : part) {
            memory_.division.zones[node] = Zone::Outside;
        }
        return {static_cast<std::size_t>(low_end - part.begin()),
                static_cast<std::size_t>(high_end - low_end)};
    }

    std::span<const SolverNode> nodes_;
    const DissectionOptions& options_;
    NodeMemory& memory_;
    PartDivider divider_;
};

}  // namespace

Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads) {
    NodeMemory memory(nodes.size());
    Dissector dissector(graph, nodes, domain, options, memory);
    dissector.dissect_all(thread_count(threads));
    return {std::move(memory.order), std::move(dissector.parts)};
}

}  // namespace foam
