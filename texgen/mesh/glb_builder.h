// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/json/json_writer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Builds a binary glTF 2.0 file (GLB): a JSON text, and the bytes of meshes and images to which it
/// refers.
class GlbBuilder {
  public:
    /// The content of the JSON text. The caller adds to it whatever no function of this class adds,
    /// such as materials.
    Json json;

    /// Begins a file with one node that shows mesh 0.
    explicit GlbBuilder(std::string_view node_name);

    /// Adds bytes, such as an image. Returns the index of the buffer view.
    std::size_t add_bytes(std::span<const std::byte> content);

    /// Adds vectors of 2, 3 or 4 components as an attribute of vertices. `limits` may have the
    /// members "min" and "max"; both are required for positions. Returns the index of the
    /// accessor.
    std::size_t add_vectors(std::span<const float> numbers, int components, const Json& limits);

    /// Adds the corners of triangles as indices of vertices. Returns the index of the accessor.
    std::size_t add_corners(std::span<const std::uint16_t> corners);
    std::size_t add_corners(std::span<const std::uint32_t> corners);

    /// Sets the only mesh of the file. `primitive` is its only primitive.
    void set_mesh(std::string_view name, Json primitive);

    /// Returns the content of the file. Call this function last. Precondition: the file is smaller
    /// than 4 GiB, because GLB stores its size in 32 bits.
    Bytes file();

  private:
    std::size_t add_view(std::span<const std::byte> content, int target);
    std::size_t add_accessor(Json accessor);

    Bytes binary_;
};

}  // namespace foam::texgen
