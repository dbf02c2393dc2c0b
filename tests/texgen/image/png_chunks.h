// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Type and content of the chunks of a stream, read as the PNG specification (section 5.3) lays
/// them out: 4 bytes length, 4 bytes type, content, 4 bytes check sum, after 8 bytes of signature.
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

/// The content of the first chunk of a type, or "none".
inline std::string chunk(const Bytes& stream, const std::string& type) {
    for (const auto& [name, content] : chunks_of(stream)) {
        if (name == type) {
            return content;
        }
    }
    return "none";
}

}  // namespace foam::texgen
