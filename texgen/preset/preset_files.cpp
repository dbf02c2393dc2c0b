// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_files.h"

#include "texgen/image/content_text.h"
#include "texgen/image/file_io.h"
#include "texgen/preset/load_preset.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

namespace fs = std::filesystem;

// The endings of the names of files that a preset may read.
constexpr std::array<std::string_view, 3> kPictureSuffixes = {".png", ".exr", ".svg"};

bool is_picture(std::string_view text) {
    return std::ranges::any_of(kPictureSuffixes, [&](std::string_view suffix) {
        return text.size() > suffix.size() && text.ends_with(suffix);
    });
}

// Collects the files of a preset.
class FileList {
  public:
    void add_preset(const fs::path& path) {
        if (!add(path)) {
            return;  // presets that extend each other in a circle
        }
        try {
            const Bytes content = read_file(path, kPresetInput);
            const fs::path folder = path.parent_path();
            for (const Assignment& one : read_assignments(text_of(content), path.string())) {
                const auto* const text = std::get_if<std::string>(&one.value.data);
                if (one.key == "extends" && text != nullptr && is_preset_path(*text)) {
                    add_preset(folder / *text);
                } else {
                    add_pictures(one, folder);
                }
            }
        } catch (const PresetError&) {
            return;
        } catch (const InputError&) {
            return;
        }
    }

    void add_pictures(const Assignment& assignment, const fs::path& folder) {
        if (!assignment.key.starts_with("output.")) {
            add_pictures(assignment.value, folder);
        }
    }

    std::vector<fs::path> take() { return std::move(files_); }

  private:
    void add_pictures(const Value& value, const fs::path& folder) {
        if (const auto* const list = std::get_if<Value::List>(&value.data)) {
            for (const Value& item : *list) {
                add_pictures(item, folder);
            }
        } else if (const auto* const text = std::get_if<std::string>(&value.data);
                   text != nullptr && is_picture(*text)) {
            add(folder / *text);
            add(*text);
        }
    }

    // Adds a file. Returns false if it is in the list already.
    bool add(const fs::path& path) {
        const fs::path normal = path.lexically_normal();
        if (std::ranges::find(files_, normal) != files_.end()) {
            return false;
        }
        files_.push_back(normal);
        return true;
    }

    std::vector<fs::path> files_;
};

}  // namespace

std::vector<fs::path> preset_files(const std::string& name_or_path,
                                   std::span<const Assignment> more) {
    FileList files;
    if (is_preset_path(name_or_path)) {
        files.add_preset(name_or_path);
    }
    for (const Assignment& assignment : more) {
        files.add_pictures(assignment, {});
    }
    return files.take();
}

}  // namespace foam::texgen
