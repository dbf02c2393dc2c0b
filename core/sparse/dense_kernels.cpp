#include "core/sparse/dense_kernels.h"

#include "core/sparse/dense_kernels_of.h"

namespace foam {

#ifdef FOAM_HAS_AVX2_KERNELS
namespace kernels {
extern template DenseKernels<float> kernels_of<float, 32>();
extern template DenseKernels<double> kernels_of<double, 32>();
}  // namespace kernels
#endif

template <class Real>
DenseKernels<Real> baseline_kernels() {
    return kernels::kernels_of<Real, 16>();
}

template <class Real>
DenseKernels<Real> best_kernels() {
#ifdef FOAM_HAS_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") != 0) {
        return kernels::kernels_of<Real, 32>();
    }
#endif
    return baseline_kernels<Real>();
}

template DenseKernels<float> baseline_kernels();
template DenseKernels<double> baseline_kernels();
template DenseKernels<float> best_kernels();
template DenseKernels<double> best_kernels();

}  // namespace foam
