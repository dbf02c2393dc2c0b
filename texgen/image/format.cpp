// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/format.h"

#include "texgen/image/file_suffix.h"
#include "texgen/image/texture_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace foam::texgen {

namespace {

// Returns the element of kImageFormats for the TextureFormat that `find` returns.
template <const TextureFormat* (*find)()>
constexpr ImageFormat texture_row(std::string_view name, std::string_view suffix) {
    return {
        .name = name,
        .suffix = suffix,
        .samples = FormatSamples::Codes,
        .code_bits = 16,
        .is_lossy = true,
        .encode =
            [](const Picture& picture, const EncodingOptions& options) {
                return encode_picture(*find(), picture, options.gpu);
            },
        .decode =
            [](std::span<const std::byte> content) { return decode_picture(*find(), content); }};
}

const TextureFormat* find_dds() {
    return find_texture_format(".dds");
}

const TextureFormat* find_ktx2() {
    return find_texture_format(".ktx2");
}

constexpr std::array kImageFormats = {
    ImageFormat{
        .name = "PNG",
        .suffix = ".png",
        .samples = FormatSamples::Codes,
        .code_bits = 16,
        .encode = [](const Picture& picture,
                     const EncodingOptions& options) { return encode_png(picture, options.png); },
        .decode = decode_png},
    ImageFormat{
        .name = "EXR",
        .suffix = ".exr",
        .samples = FormatSamples::Numbers,
        .has_layers = true,
        .encode = [](const Picture& picture,
                     const EncodingOptions& options) { return encode_exr(picture, options.exr); },
        .decode = [](std::span<const std::byte> content) { return decode_exr(content); }},
    texture_row<find_dds>("DDS", ".dds"),
    texture_row<find_ktx2>("KTX2", ".ktx2"),
};

/// Returns the values of one member of all formats as a text such as "a, b or c".
std::string alternatives(std::string_view ImageFormat::*word) {
    std::string list;
    for (std::size_t k = 0; k < kImageFormats.size(); ++k) {
        list += k == 0 ? "" : k + 1 < kImageFormats.size() ? ", " : " or ";
        list += kImageFormats.at(k).*word;
    }
    return list;
}

}  // namespace

std::span<const ImageFormat> image_formats() {
    return kImageFormats;
}

const ImageFormat* find_format(std::string_view file_name) {
    const auto* const found = std::ranges::find_if(kImageFormats, [&](const ImageFormat& format) {
        return has_suffix(file_name, format.suffix);
    });
    return found != kImageFormats.end() ? found : nullptr;
}

std::string format_suffixes() {
    return alternatives(&ImageFormat::suffix);
}

std::string format_names() {
    return alternatives(&ImageFormat::name);
}

Picture read_picture(const std::filesystem::path& path) {
    const ImageFormat* const format = find_format(path.string());
    if (format == nullptr) {
        fail_to_read(path, fmt::format("its name must end in {}", format_suffixes()));
    }
    return decode_file(path, format->decode);
}

}  // namespace foam::texgen
