// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/picture_file.h"

#include "core/files/file_io.h"
#include "texgen/image/format.h"
#include "texgen/image/memory.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/primaries.h"

#include <fmt/core.h>

#include <variant>

namespace foam::texgen {

bool is_picture_name(std::string_view text) {
    return find_format(text) != nullptr;
}

std::string picture_suffix_pattern() {
    std::string pattern;
    for (const ImageFormat& format : image_formats()) {
        pattern += pattern.empty() ? "(" : "|";
        for (const char c : format.suffix.substr(1)) {
            const char capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
            pattern += c == capital ? std::string(1, c) : fmt::format("[{}{}]", c, capital);
        }
    }
    return "\\\\." + pattern + ")";
}

PictureFile read_picture_file(const std::string& path) {
    Picture picture = read_picture(path);
    convert_colors(picture, "", picture.metadata.primaries, Primaries::Srgb);
    return {path,
            std::make_shared<const SourcePicture>(source_picture_of(picture, path)),
            pixel_hash(picture)};
}

std::string PictureFiles::allowed() const {
    return fmt::format("the path of a picture, which ends in {}, or \"\"", format_suffixes());
}

std::string PictureFiles::schema() const {
    return fmt::format(R"({{"type": "string", "pattern": "^$|{}$"}})", picture_suffix_pattern());
}

bool PictureFiles::read(const Value& value, PictureFile& member) const {
    const auto* const path = std::get_if<std::string>(&value.data);
    if (path == nullptr) {
        return false;
    }
    try {
        member = path->empty() ? PictureFile{} : read_picture_file(*path);
        return true;
    } catch (const InputError&) {
        return false;
    } catch (const OutOfMemory&) {
        return false;
    }
}

std::optional<NamedFile> PictureFiles::file(const PictureFile& member) const {
    return member.is_set() ? std::optional(NamedFile{member.path, member.hash}) : std::nullopt;
}

std::string PictureFiles::fault(const Value& value) const {
    const auto* const path = std::get_if<std::string>(&value.data);
    if (path == nullptr || path->empty()) {
        return {};
    }
    try {
        read_picture_file(*path);
        return {};
    } catch (const InputError& error) {
        return error.what();
    } catch (const OutOfMemory& error) {
        return error.what();
    }
}

}  // namespace foam::texgen
