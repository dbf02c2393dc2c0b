#include "texgen/raster/parallel_for.h"

#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    const auto end = static_cast<std::size_t>(std::max(count, 0));
    parallel_for(end, 1, threads, [&](std::size_t k, std::size_t) { body(static_cast<int>(k)); });
}

void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    foam::parallel_for(0, count, grain, std::max(threads, 1), body);
}

}  // namespace foam::texgen
