#include "texgen/raster/coverage/pixel_means.h"

#include "texgen/raster/simd/kernel.h"

namespace foam::texgen {

namespace {

template <class Sums>
void find(std::span<const typename Sums::Number> sums, std::uint16_t* to) {
    at_simd_level([sums, to] {
        std::uint16_t* __restrict means = to;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            means[k] = static_cast<std::uint16_t>(Sums::mean(sums[k]));
        }
    });
}

}  // namespace

void find_means(std::span<const double> sums, std::uint16_t* means) {
    find<ExactSums<1>>(sums, means);
}

void find_means(std::span<const std::uint32_t> sums, std::uint16_t* means) {
    find<SmallSums<1>>(sums, means);
}

}  // namespace foam::texgen
