// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/memory_need.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::uint64_t kHuge = 12'345'678'900'000'000;

std::string warning(const MemoryNeed& need) {
    testing::internal::CaptureStderr();
    warn_of_little_memory(need);
    return testing::internal::GetCapturedStderr();
}

TEST(MemoryNeed, WarnsOfTooLittleMemory) {
    EXPECT_EQ(warning({1, "image.size"}), "");
    const std::string text = warning({kHuge, "image.size"});
    EXPECT_TRUE(text.starts_with("foamtex: warning: only ")) << text;
    EXPECT_TRUE(
        text.ends_with("B of memory are available, but this needs about 12345678.9 GB; "
                       "lower image.size\n"))
        << text;
}

TEST(MemoryNeed, GrowsWithTheFoamAndTheImages) {
    Preset preset;
    const MemoryNeed to_simulate = memory_to_simulate(preset);
    const MemoryNeed to_bake = memory_to_bake(preset, 1, 1);
    EXPECT_LT(to_simulate.bytes, to_bake.bytes);
    EXPECT_EQ(text_of(to_simulate).substr(text_of(to_simulate).find(';')), "; lower foam.bubbles");
    const std::string advice = "; lower --threads, image.size or foam.bubbles";
    EXPECT_TRUE(text_of(to_bake).ends_with(advice)) << text_of(to_bake);
    preset.seeding.bubbles *= 100;
    EXPECT_LT(to_simulate.bytes, memory_to_simulate(preset).bytes);
    preset.image.width *= 2;
    EXPECT_LT(to_bake.bytes, memory_to_bake(preset, 1, 1).bytes);
}

TEST(MemoryNeed, OfVariationsCountsThePicturesThatAreDrawnAtOnce) {
    const std::vector<Preset> one(1);
    const std::vector<Preset> three(3);
    const auto need = [](const std::vector<Preset>& presets, int threads, int side) {
        return memory_to_vary(presets, {.map = "albedo", .side = side, .threads = threads}).bytes;
    };
    EXPECT_LT(need(one, 1, 256), need(one, 1, 1024));
    EXPECT_EQ(need(one, 1, 256), need(one, 8, 256));
    EXPECT_LT(need(three, 1, 256), 2 * need(one, 1, 256));
    EXPECT_LT(2 * need(one, 1, 256), need(three, 3, 256));
    EXPECT_EQ(need(three, 3, 256), need(three, 8, 256));
    const std::string text = text_of(memory_to_vary(one, {.map = "albedo"}));
    EXPECT_TRUE(text.ends_with("; lower --threads, --width or foam.bubbles")) << text;
}

TEST(MemoryNeed, IsPartOfTheErrorIfMemoryRunsOut) {
    EXPECT_EQ(with_memory({}, [] { return 7; }), 7);
    const auto run_out = []() -> int { throw std::bad_alloc(); };
    try {
        with_memory({5'000'000'000, ""}, run_out);
        ADD_FAILURE() << "no error";
    } catch (const OutOfMemory& error) {
        EXPECT_EQ(std::string(error.what()), "this needs about 5.0 GB");
    }
}

}  // namespace
}  // namespace foam::texgen
