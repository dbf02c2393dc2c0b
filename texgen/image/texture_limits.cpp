// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/texture_limits.h"

#include "core/files/file_io.h"
#include "core/files/input_limits.h"
#include "texgen/image/memory.h"
#include "texgen/image/pixel_format.h"

#include <fmt/core.h>

namespace foam::texgen {

void check_texture_size(std::string_view format,
                        std::uint32_t width,
                        std::uint32_t height,
                        std::uint32_t levels,
                        std::uint32_t layers) {
    if (width == 0 || height == 0) {
        throw InputError(fmt::format("malformed {}: the image has no pixels", format));
    }
    if (width > kMaxImageExtent || height > kMaxImageExtent ||
        static_cast<std::int64_t>(width) * height > kMaxImagePixels) {
        throw InputError(
            fmt::format("the image is {} x {} pixels, more than foamtex reads", width, height));
    }
    const int max_levels = full_level_count(static_cast<int>(width), static_cast<int>(height));
    if (levels == 0 || levels > static_cast<std::uint32_t>(max_levels)) {
        throw InputError(
            fmt::format("the {} has {} mip levels, but foamtex reads 1 to {} for {} x {} pixels",
                        format,
                        levels,
                        max_levels,
                        width,
                        height));
    }
    if (layers == 0 || layers > kMaxLayers) {
        throw InputError(fmt::format(
            "the {} has {} layers, but foamtex reads 1 to {}", format, layers, kMaxLayers));
    }
}

void check_supported(std::string_view format, bool holds, std::string_view property) {
    if (!holds) {
        throw InputError(fmt::format("the {} {}, which foamtex does not read", format, property));
    }
}

void require_texture_memory(std::uint64_t bytes, int width, int height) {
    require_memory(bytes, fmt::format("a texture of {} x {} pixels", width, height));
}

}  // namespace foam::texgen
