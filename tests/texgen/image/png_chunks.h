// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Returns the type and the content of each chunk of a PNG. The stream has a signature of 8 bytes.
/// Each chunk has a length of 4 bytes, a type of 4 bytes, the content, and a CRC of 4 bytes (PNG
/// specification, section 5.3).
inline std::vector<std::pair<std::string, std::string>> chunks_of(const Bytes& stream) {
    const std::string bytes(reinterpret_cast<const char*>(stream.data()), stream.size());
    std::vector<std::pair<std::string, std::string>> chunks;
    for (std::size_t at = 8; at < bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length * 256 + static_cast<unsigned char>(bytes[at + i]);
        }
        chunks.emplace_back(bytes.substr(at + 4, 4), bytes.substr(at + 8, length));
        at += length + 12;
    }
    return chunks;
}

/// Returns the content of the first chunk of a type, or "none".
inline std::string chunk(const Bytes& stream, const std::string& type) {
    for (const auto& [name, content] : chunks_of(stream)) {
        if (name == type) {
            return content;
        }
    }
    return "none";
}

}  // namespace foam::texgen
