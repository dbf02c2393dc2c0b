#include "core/sparse/dense_kernels_of.h"

namespace foam::kernels {

template DenseKernels<float> kernels_of<float, 32>();
template DenseKernels<double> kernels_of<double, 32>();

}  // namespace foam::kernels
