// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_workspace.h"

#include <algorithm>
#include <array>
#include <vector>

namespace foam {

// In postorder, the update matrix that was computed last is needed first. Multifrontal methods
// therefore keep update matrices on a stack (Duff, Reid 1983; J. W. H. Liu, The multifrontal method
// for sparse matrix solution, SIAM Review 34, 1992). With one stack, the update matrix of a front
// would overlap the update matrices of its children, from which it is computed. The front's update
// matrix would therefore have to be moved. The two stacks used here avoid such moves; they are our
// own method. The layout is computed once per plan, so that factoring allocates no update matrices.

namespace {

// The number of topmost levels on which the two subtrees of a front share no memory. Two threads
// can factor such subtrees at the same time (Front::may_fork).
constexpr int kForkLevels = 4;
static_assert(kMaxWorkers == 1 << kForkLevels);

std::size_t update_size(const Front& front) {
    return front.border * front.border;
}

// Two stacks of update matrices: one for the even levels of the tree, one for the odd levels. A
// front and its children use different stacks, so that the front's update matrix never overlaps the
// update matrices of its children.
class Stacks {
  public:
    explicit Stacks(std::span<Front> fronts) : fronts_(fronts), odd_(fronts.size()) {}

    std::size_t run() {
        lay_out(fronts_.size() - 1, 0, {0, 0});
        for (std::size_t k = 0; k < fronts_.size(); ++k) {
            fronts_[k].update_begin += odd_[k] ? peaks_[0] : 0;
        }
        return peaks_[0] + peaks_[1];
    }

  private:
    // Lays out the update matrices of a subtree. `tops` holds, for each of the two stacks, the
    // first index that the subtree may use.
    void lay_out(std::size_t root, int level, std::array<std::size_t, 2> tops) {
        Front& front = fronts_[root];
        const std::size_t own = level % 2 == 0 ? 0 : 1;
        odd_[root] = own == 1;
        front.update_begin = tops[own];
        const std::size_t end = tops[own] + update_size(front);
        if (!front.is_leaf()) {
            front.may_fork = level < kForkLevels;
            lay_out(front.left, level + 1, tops);
            tops[1 - own] += update_size(fronts_[front.left]);
            lay_out(front.right, level + 1, front.may_fork ? peaks_ : tops);
        }
        peaks_[own] = std::max(peaks_[own], end);
    }

    std::span<Front> fronts_;
    std::vector<bool> odd_;                   // true for each front on an odd level
    std::array<std::size_t, 2> peaks_{0, 0};  // largest size so far of each stack
};

}  // namespace

std::size_t share_workspace(std::span<Front> fronts) {
    return Stacks(fronts).run();
}

}  // namespace foam
