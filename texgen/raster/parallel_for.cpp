#include "texgen/raster/parallel_for.h"

#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    const auto end = static_cast<std::size_t>(std::max(count, 0));
    foam::parallel_for(0, end, 1, std::max(threads, 1), [&](std::size_t k, std::size_t) {
        body(static_cast<int>(k));
    });
}

}  // namespace foam::texgen
