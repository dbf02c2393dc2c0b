// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_workspace.h"

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/foam/seeding.h"
#include "core/sparse/front_planner.h"
#include "tests/core/sparse/grids.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

FrontPlan plan_of(int bubbles) {
    SeedingOptions options;
    options.bubbles = bubbles;
    const Foam foam = seed_foam(options);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Hessian hessian(foam.network, unknowns);
    return *test::plan_within(
        hessian.matrix(), solver_nodes(foam, unknowns), foam.domain, std::size_t{1} << 30U);
}

// Simulates the factorization: a front fills its update matrix with its own index, and the update
// matrices of its children must still hold theirs.
class Playback {
  public:
    explicit Playback(const FrontPlan& plan) : plan_(plan), owners_(plan.workspace_size) {}

    void play(std::size_t k) {
        const Front& front = plan_.fronts[k];
        ASSERT_LE(front.update_begin + front.border * front.border, owners_.size());
        fill(front, k);
        if (!front.is_leaf()) {
            expect_kept(front.left);
            expect_kept(front.right);
        }
    }

    // Processes the two subtrees of a front in lockstep, and then the front.
    void play_fork(std::size_t root) {
        play_side_by_side(plan_.fronts[root].left, plan_.fronts[root].right);
        play(root);
    }

  private:
    void play_side_by_side(std::size_t left, std::size_t right) {
        std::size_t a = plan_.fronts[left].first_descendant;
        std::size_t b = plan_.fronts[right].first_descendant;
        while (a <= left || b <= right) {
            if (a <= left) {
                play(a++);
            }
            if (b <= right) {
                play(b++);
            }
        }
    }

    void fill(const Front& front, std::size_t value) {
        for (std::size_t k = 0; k < front.border * front.border; ++k) {
            owners_[front.update_begin + k] = value;
        }
    }

    void expect_kept(std::size_t child) {
        const Front& front = plan_.fronts[child];
        for (std::size_t k = 0; k < front.border * front.border; ++k) {
            ASSERT_EQ(owners_[front.update_begin + k], child);
        }
    }

    const FrontPlan& plan_;
    std::vector<std::size_t> owners_;
};

TEST(FrontWorkspace, KeepsUpdateMatricesUntilTheyAreUsed) {
    for (const int bubbles : {2, 30, 300}) {
        const FrontPlan plan = plan_of(bubbles);
        Playback playback(plan);
        for (std::size_t k = 0; k < plan.fronts.size(); ++k) {
            playback.play(k);
        }
    }
}

TEST(FrontWorkspace, SeparatesFrontsFactoredConcurrently) {
    const FrontPlan plan = plan_of(300);
    int forks = 0;
    for (std::size_t k = 0; k < plan.fronts.size(); ++k) {
        if (plan.fronts[k].may_fork) {
            Playback(plan).play_fork(k);
            ++forks;
        }
    }
    EXPECT_EQ(forks, kMaxWorkers - 1);
}

TEST(FrontWorkspace, IsSmallerThanAllUpdateMatricesTogether) {
    const FrontPlan plan = plan_of(1000);
    std::size_t total = 0;
    for (const Front& front : plan.fronts) {
        total += front.border * front.border;
    }
    EXPECT_LT(2 * plan.workspace_size, total);
}

}  // namespace
}  // namespace foam
