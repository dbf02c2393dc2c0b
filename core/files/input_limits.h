// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace foam {

// The limits of files that the program reads. They bound the memory and the time that reading a
// file from an untrusted source can cost. SECURITY.md lists them.

/// A kind of input file.
struct InputKind {
    std::string_view name;        // for messages, such as "a foam"
    std::uint64_t max_bytes = 0;  // the largest size of a file
};

inline constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20U;

inline constexpr InputKind kPresetInput{"a preset, a profile or a file of tolerances", kMebibyte};
inline constexpr InputKind kJobsInput{"a job file", 64 * kMebibyte};
inline constexpr InputKind kFoamInput{"a foam", 1024 * kMebibyte};
inline constexpr InputKind kDescriptionInput{
    "a manifest or the description of a cache or a flipbook", 512 * kMebibyte};
inline constexpr InputKind kStateInput{"a state of a cache", 1024 * kMebibyte};
inline constexpr InputKind kImageInput{"an image", 4096 * kMebibyte};
inline constexpr InputKind kDrawingInput{"a drawing (SVG)", 16 * kMebibyte};

/// All kinds of input files.
inline constexpr std::array kInputKinds = {kPresetInput,
                                           kJobsInput,
                                           kFoamInput,
                                           kDescriptionInput,
                                           kStateInput,
                                           kImageInput,
                                           kDrawingInput};

/// The largest size of the uncompressed content of a state of a cache, in bytes.
inline constexpr std::uint64_t kMaxStateContent = 4096 * kMebibyte;

/// The largest number of pixels of an image: 32768 x 32768.
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 30U;

/// The largest width and the largest height of an image, in pixels. libpng has the same limit.
inline constexpr std::int64_t kMaxImageExtent = 1'000'000;

/// Identities of bubbles in a cache must be below this number, because maps need memory in
/// proportion to the largest identity.
inline constexpr std::uint32_t kMaxIdentity = 1U << 23U;

}  // namespace foam
