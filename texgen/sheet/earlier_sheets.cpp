// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/earlier_sheets.h"

#include "core/files/file_io.h"

#include <algorithm>
#include <string_view>

namespace foam::texgen {

namespace {

// Returns the description of a flipbook (flipbook_json) in a file, or null if there is none.
Json description_in(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        return nullptr;
    }
    const Bytes bytes = read_file(file, kDescriptionInput);
    const Json json = Json::parse(bytes.begin(), bytes.end(), nullptr, false);
    return json.is_object() && json.value("images", Json()).is_array() ? json : Json();
}

std::string text_of(const Json& image, const char* member) {
    const Json value = image.is_object() ? image.value(member, Json()) : Json();
    return value.is_string() ? value.get<std::string>() : "";
}

// Returns true if two descriptions are equal, except for the members that depend on the maps.
bool same_but_for_maps(Json a, Json b) {
    for (const char* const member : {"images", "conventions"}) {
        a.erase(member);
        b.erase(member);
    }
    return a == b;
}

bool has_sheet(const Json& images, const char* member, const std::string& text) {
    return std::ranges::any_of(images,
                               [&](const Json& image) { return text_of(image, member) == text; });
}

}  // namespace

std::vector<std::string> keep_earlier_sheets(Json& description, const std::filesystem::path& file) {
    const Json earlier = description_in(file);
    std::vector<std::string> unlisted;
    if (earlier.is_null()) {
        return unlisted;
    }
    const bool same = same_but_for_maps(description, earlier);
    Json& images = description["images"];
    for (const Json& image : earlier["images"]) {
        const std::string name = text_of(image, "file");
        if (name.empty() || has_sheet(images, "file", name) ||
            !std::filesystem::exists(file.parent_path() / name)) {
            continue;
        }
        if (same && !has_sheet(images, "map", text_of(image, "map"))) {
            images.push_back(image);
        } else {
            unlisted.push_back(name);
        }
    }
    return unlisted;
}

}  // namespace foam::texgen
