// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace foam::texgen {

/// The first bytes of every PNG.
inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// A chunk of a PNG. Refers to the bytes of the PNG.
struct PngChunk {
    std::string_view type;
    std::span<const std::byte> content;
};

/// Returns the bytes after the signature, or nullopt if the bytes do not begin with it.
std::optional<std::span<const std::byte>> after_png_signature(std::span<const std::byte> png);

/// Removes the first chunk from the rest of a PNG and returns it. A chunk has the length of its
/// content, its type, its content and a checksum (PNG specification, section 5.3). Returns nullopt
/// if the chunk is incomplete; `rest` is then unchanged.
std::optional<PngChunk> take_png_chunk(std::span<const std::byte>& rest);

}  // namespace foam::texgen
