// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/network/ids.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

namespace foam::texgen {

/// Gives numbers to the nodes of a net of lines (NetArc). The periodic copies of a point of a torus
/// are different nodes.
class NetNodes {
  public:
    /// Returns the node of a periodic copy of a point. `point` is the index of the point.
    std::uint64_t node_of(std::size_t point, LatticeOffset copy) {
        return numbers_.try_emplace({point, copy.i, copy.j}, next_node()).first->second;
    }
    std::uint64_t node_of(JunctionId junction, LatticeOffset copy) {
        return node_of(index_of(junction), copy);
    }
    /// Returns a new node, for an end of an arc that no other arc shares.
    std::uint64_t unshared_node() { return next_unshared_++; }

  private:
    std::uint64_t next_node() const { return numbers_.size(); }

    std::map<std::tuple<std::size_t, std::int32_t, std::int32_t>, std::uint64_t> numbers_;
    std::uint64_t next_unshared_ = std::uint64_t{1} << 63;
};

}  // namespace foam::texgen
