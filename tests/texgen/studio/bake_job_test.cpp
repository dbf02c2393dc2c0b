// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/bake_job.h"

#include "core/files/scratch_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace foam::texgen {
namespace {

BakeRequest small_bake() {
    return {.settings = {.preset = "sea_foam",
                         .set = {"foam.bubbles=40", "frames.count=3", "image.size=[16, 16]"}},
            .folder = "out",
            .frames = "1"};
}

TEST(BakeJobs, ABakeCanStartAfterAnotherWasStopped) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    FrameStore store(1UL << 20);
    BakeJobs bakes(folder, store);
    bakes.start(small_bake());
    bakes.stop();
    EXPECT_FALSE(bakes.is_running());
    const Json second = bakes.start(small_bake());
    EXPECT_EQ(second["bake"], 2);
    while (bakes.is_running()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(bakes.status(2)["status"], "complete");
}

TEST(BakeJobs, AnImpossibleSceneIsRejectedBeforeTheBake) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    FrameStore store(1UL << 20);
    BakeJobs bakes(folder, store);
    BakeRequest request = small_bake();
    request.maps = {"id"};
    request.settings.set.emplace_back("output.scene=[\"usda\"]");
    EXPECT_THROW(bakes.start(request), std::invalid_argument);
    EXPECT_FALSE(bakes.is_running());
}

}  // namespace
}  // namespace foam::texgen
