// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/earlier_sheets.h"

#include "core/files/file_io.h"
#include "texgen/json/json_value.h"

#include <algorithm>
#include <system_error>

namespace foam::texgen {

namespace {

// Parses the description of a flipbook (flipbook_json). Returns null if the text is not one, or if
// JsonDocument rejects it, for example because it is nested too deeply to be copied.
Json parsed_description(std::string_view text) {
    try {
        const JsonDocument checked(text, "the earlier flipbook");
    } catch (const InputError&) {
        return nullptr;
    }
    const Json json = Json::parse(text);
    return json.is_object() && json.value("images", Json()).is_array() ? json : Json();
}

std::string text_of(const Json& image, const char* member) {
    const Json value = image.is_object() ? image.value(member, Json()) : Json();
    return value.is_string() ? value.get<std::string>() : "";
}

// Returns the file name of the sheet that `image` describes, or an empty text if there is none.
// The description may come from an untrusted source, so it must not name a file in another folder.
std::string file_of(const Json& image) {
    const std::string name = text_of(image, "file");
    return is_plain_name(name) ? name : "";
}

bool file_exists(const std::filesystem::path& file) {
    std::error_code ignored;  // for example, the name may be too long
    return std::filesystem::exists(file, ignored);
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

EarlierSheets keep_earlier_sheets(Json& description,
                                  std::string_view earlier,
                                  const std::filesystem::path& folder) {
    const Json listed = parsed_description(earlier);
    EarlierSheets result;
    if (listed.is_null()) {
        return result;
    }
    const bool same = same_but_for_maps(description, listed);
    const bool same_bake = text_of(listed, "parameters") == text_of(description, "parameters");
    Json& images = description["images"];
    for (const Json& image : listed["images"]) {
        const std::string name = file_of(image);
        if (name.empty() || !file_exists(folder / name)) {
            continue;
        }
        if (has_sheet(images, "file", name)) {
            if (!same_bake) {
                result.replaced.push_back(name);
            }
        } else if (same && !has_sheet(images, "map", text_of(image, "map"))) {
            images.push_back(image);
        } else {
            result.unlisted.push_back(name);
        }
    }
    return result;
}

}  // namespace foam::texgen
