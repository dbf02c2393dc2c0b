#include "texgen/image/decoded_file.h"

#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/png.h"

#include <fmt/core.h>

#include <utility>

namespace foam::texgen {

namespace {

DecodedFile decode_png_file(const std::filesystem::path& path) {
    DecodedFile file;
    PngSamples read = read_png_samples(path);
    std::visit(
        [&](auto& samples) {
            file.pixels = pixel_hash(std::as_const(samples).view());
            file.blocks.push_back({"", std::move(samples)});
        },
        read);
    return file;
}

DecodedFile decode_exr_file(const std::filesystem::path& path) {
    DecodedFile file;
    ExrImage read = read_exr(path);
    file.pixels = pixel_hash(read);
    for (ExrPlane& plane : read.channels) {
        std::visit(
            [&](auto& samples) {
                file.blocks.push_back({plane.name, std::move(samples)});
            },
            plane.pixels);
    }
    return file;
}

}  // namespace

DecodedFile decode_file(const std::filesystem::path& path) {
    if (path.extension() == ".png") {
        return decode_png_file(path);
    }
    if (path.extension() == ".exr") {
        return decode_exr_file(path);
    }
    throw InputError(
        fmt::format("cannot read '{}': its name must end in .png or .exr", path.string()));
}

std::vector<const SampleBlock*> blocks_of(const DecodedFile& file, std::string_view map) {
    const std::string layer = std::string(map) + '.';
    std::vector<const SampleBlock*> of_map;
    for (const SampleBlock& block : file.blocks) {
        if (block.name.find('.') == std::string::npos || block.name.starts_with(layer)) {
            of_map.push_back(&block);
        }
    }
    return of_map;
}

}  // namespace foam::texgen
