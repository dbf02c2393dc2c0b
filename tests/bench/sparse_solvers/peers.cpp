// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/peers.h"

namespace foam::bench {

std::vector<Result> peer_results(const System& system) {
    std::vector<Result> results{eigen_result(system)};
#ifdef FOAMTEX_PEER_CHOLMOD
    for (Result& result : cholmod_results(system)) {
        results.push_back(std::move(result));
    }
#endif
#ifdef FOAMTEX_PEER_MUMPS
    results.push_back(mumps_result(system));
#endif
    return results;
}

#ifndef FOAMTEX_PEER_METIS
std::optional<Result> metis_order(const System& /*system*/) {
    return std::nullopt;
}
#endif

}  // namespace foam::bench
