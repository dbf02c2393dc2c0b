// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/halving.h"

#include "core/geometry/narrow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace foam {

namespace {

// A coordinate and the node that has it. Sorted by coordinate, then by the index of the node.
using SortedNode = std::pair<double, std::uint32_t>;

// A cyclic array of numbers. Adds a number to a range of elements in constant time, because it
// stores only the differences of successive elements.
class CyclicDifferences {
  public:
    explicit CyclicDifferences(std::size_t size) : differences_(size) {}

    // Adds a value to `count` elements from `first` on. The last element is followed by the first.
    // Precondition: first <= 2 * size, count <= size.
    void add(std::size_t first, std::size_t count, int value) {
        const std::size_t size = differences_.size();
        first %= size;
        differences_[first] += value;
        differences_[(first + count) % size] -= value;
        differences_[0] += first + count >= size ? value : 0;
    }

    std::vector<int> elements() const {
        std::vector<int> sums(differences_.size());
        std::partial_sum(differences_.begin(), differences_.end(), sums.begin());
        return sums;
    }

  private:
    std::vector<int> differences_;
};

// The rows beside each of the lines that may separate two successive nodes in the cyclic order of
// the nodes along an axis. Line k is between the nodes k - 1 and k.
struct Rims {
    std::vector<int> before;  // rows of the nodes before the line that have neighbors after it
    std::vector<int> after;   // rows of the nodes after the line that have neighbors before it
};

// Finds the rims of all lines. `numbers` has the number of each node in the order along the axis.
// An edge crosses the lines on the shorter way around the torus between its two nodes. If both ways
// are equally long, each of the two nodes counts the way after it.
Rims rims_of_all_lines(std::span<const SortedNode> sorted,
                       std::span<const SolverNode> nodes,
                       const NodeGraph& graph,
                       std::span<const std::uint32_t> numbers) {
    const std::size_t size = sorted.size();
    CyclicDifferences before(size);
    CyclicDifferences after(size);
    for (std::size_t k = 0; k < size; ++k) {
        const std::uint32_t node = sorted[k].second;
        std::size_t ahead = 0;   // the distance to the farthest neighbor after the node
        std::size_t behind = 0;  // the distance to the farthest neighbor before the node
        for (const std::uint32_t neighbor : graph.neighbors_of(node)) {
            const std::size_t other = numbers[neighbor];
            if (other == kNoNumber) {
                continue;
            }
            const std::size_t distance = other >= k ? other - k : other + size - k;
            if (distance <= size / 2) {
                ahead = std::max(ahead, distance);
            } else {
                behind = std::max(behind, size - distance);
            }
        }
        before.add(k + 1, ahead, nodes[node].rows);
        after.add(k + size + 1 - behind, behind, nodes[node].rows);
    }
    return {before.elements(), after.elements()};
}

// Returns the line at which a range of `length` nodes should begin, so that the separator of this
// range from all other nodes is lightest. The separator is one of two sets of nodes: the rims
// inside the range (after its first line and before its last line), or the rims outside of it.
std::size_t lightest_start(const Rims& rims, std::size_t length) {
    const std::size_t size = rims.before.size();
    std::size_t best = 0;
    int lightest = std::numeric_limits<int>::max();
    for (std::size_t start = 0; start < size; ++start) {
        const std::size_t end = (start + length) % size;
        const int weight =
            std::min(rims.after[start] + rims.before[end], rims.before[start] + rims.after[end]);
        if (weight < lightest) {
            lightest = weight;
            best = start;
        }
    }
    return best;
}

}  // namespace

Vec2 periods_of(const Domain& domain) {
    return domain.is_plane() ? Vec2(Vec2::Constant(std::numeric_limits<double>::max()))
                             : Vec2(domain.width, domain.height);
}

double halve_at_median(std::span<const std::uint32_t> part,
                       std::span<const SolverNode> nodes,
                       const Vec2& periods,
                       const PartBox& box,
                       Eigen::Index axis,
                       std::span<Zone> zones) {
    const double middle = 0.5 * (box.low[axis] + box.high[axis]);
    std::vector<SortedNode> sorted;  // with coordinates relative to the middle
    sorted.reserve(part.size());
    for (const std::uint32_t node : part) {
        const double from_middle = nodes[node].position[axis] - middle;
        const double key = from_middle - periods[axis] * std::round(from_middle / periods[axis]);
        sorted.emplace_back(std::isfinite(key) ? key : 0.0, node);
    }
    const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), median, sorted.end());
    for (auto element = sorted.begin(); element != sorted.end(); ++element) {
        zones[element->second] = element < median ? Zone::Low : Zone::High;
    }
    return middle + median->first;
}

LowRange halve_at_lightest_position(std::span<const std::uint32_t> part,
                                    std::span<const SolverNode> nodes,
                                    const NodeGraph& graph,
                                    double period,
                                    Eigen::Index axis,
                                    std::span<Zone> zones) {
    std::vector<SortedNode> sorted;
    sorted.reserve(part.size());
    for (const std::uint32_t node : part) {
        const double x = nodes[node].position[axis];
        const double wrapped = x - period * std::floor(x / period);
        sorted.emplace_back(wrapped >= 0.0 && wrapped <= period ? wrapped : 0.0, node);
    }
    std::ranges::sort(sorted);
    const std::size_t size = sorted.size();
    std::vector<std::uint32_t> numbers(nodes.size(), kNoNumber);
    for (std::size_t k = 0; k < size; ++k) {
        numbers[sorted[k].second] = narrow(k);
    }
    const std::size_t start =
        lightest_start(rims_of_all_lines(sorted, nodes, graph, numbers), size / 2);
    for (std::size_t k = 0; k < size; ++k) {
        zones[sorted[(start + k) % size].second] = k < size / 2 ? Zone::Low : Zone::High;
    }
    const std::size_t end = start + size / 2;
    return {sorted[start].first,
            end < size ? sorted[end].first : sorted[end - size].first + period};
}

void separate_halves(std::span<const std::uint32_t> part,
                     std::span<const SolverNode> nodes,
                     const NodeGraph& graph,
                     std::span<Zone> zones) {
    std::array<std::vector<std::uint32_t>, 2> rims;
    std::array<int, 2> weights{};
    for (const std::uint32_t node : part) {
        const Zone zone = zones[node];
        const auto neighbors = graph.neighbors_of(node);
        if (std::any_of(neighbors.begin(), neighbors.end(), [&](std::uint32_t neighbor) {
                return zones[neighbor] == opposite(zone);
            })) {
            const std::size_t half = zone == Zone::High ? 1 : 0;
            rims[half].push_back(node);
            weights[half] += nodes[node].rows;
        }
    }
    for (const std::uint32_t node : rims[weights[1] < weights[0] ? 1 : 0]) {
        zones[node] = Zone::Outside;
    }
}

}  // namespace foam
