// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

namespace {

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

template <class Number>
void append_numbers(std::string& file, std::span<const Number> numbers) {
    const auto bytes = std::as_bytes(numbers);
    file.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

// Returns the header of the file. Programs take an STL file for the text format if it begins with
// "solid", so this header begins with another word. It ends with a zero byte, because programs such
// as admesh print everything up to the first one.
std::string header_of(std::string_view title) {
    std::string header = "foamtex mesh in millimeters: ";
    header += title;
    header.resize(kHeaderBytes - 1, ' ');
    std::ranges::replace_if(
        header, [](char c) { return c < ' ' || c > '~'; }, '?');
    header += '\0';
    return header;
}

}  // namespace

std::string to_stl(const Mesh& mesh, std::string_view title) {
    std::string file = header_of(title);
    file.reserve(kHeaderBytes + 4 + kTriangleBytes * mesh.triangles.size());
    const std::array count{static_cast<std::uint32_t>(mesh.triangles.size())};
    append_numbers<std::uint32_t>(file, count);
    for (const Triangle& triangle : mesh.triangles) {
        const std::array<double, 3> normal = normalized(area_vector(mesh, triangle));
        append_numbers<float>(file,
                              std::array{static_cast<float>(normal[0]),
                                         static_cast<float>(normal[1]),
                                         static_cast<float>(normal[2])});
        for (const std::uint32_t corner : triangle) {
            append_numbers<float>(file, mesh.positions[corner]);
        }
        append_numbers<std::uint16_t>(file, std::array<std::uint16_t, 1>{0});  // no attributes
    }
    return file;
}

}  // namespace foam::texgen
