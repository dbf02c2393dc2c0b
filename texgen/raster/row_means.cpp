#include "texgen/raster/row_means.h"

#include "texgen/raster/simd/vector_clones.h"

namespace foam::texgen {

namespace {

// Inlined, or the copies for other processors would share this one.
template <class Sums>
[[gnu::always_inline]] inline void find(std::span<const typename Sums::Number> sums,
                                        std::uint16_t* __restrict means) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
        means[k] = static_cast<std::uint16_t>(Sums::mean(sums[k]));
    }
}

}  // namespace

FOAMTEX_VECTOR_CLONES void find_means(std::span<const double> sums, std::uint16_t* means) {
    find<ExactSums<1>>(sums, means);
}

FOAMTEX_VECTOR_CLONES void find_means(std::span<const std::uint32_t> sums, std::uint16_t* means) {
    find<SmallSums<1>>(sums, means);
}

}  // namespace foam::texgen
