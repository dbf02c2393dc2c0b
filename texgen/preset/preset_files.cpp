// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_files.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_keys.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

namespace fs = std::filesystem;

// Collects the files of a preset.
class FileList {
  public:
    void add_preset(const fs::path& path) {
        if (!add(path)) {
            return;  // presets that extend each other in a circle
        }
        try {
            const Bytes content = read_file(path, kPresetInput);
            add_named(read_assignments(as_text(content), path.string()), path.parent_path());
        } catch (const PresetError&) {
            return;
        } catch (const InputError&) {
            return;
        }
    }

    // Adds the files that the assignments name. Their paths are relative to the folder.
    void add_named(std::vector<Assignment> assignments, const fs::path& folder) {
        for (const Assignment& one : assignments) {
            const auto* const text = std::get_if<std::string>(&one.value.data);
            if (one.key == "extends" && text != nullptr && is_preset_path(*text)) {
                add_preset(folder / *text);
            }
        }
        locate_files(assignments, [&](const std::string& path) {
            add(folder / path);
            return path;
        });
    }

    std::vector<fs::path> take() { return std::move(files_); }

  private:
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
    files.add_named({more.begin(), more.end()}, {});
    return files.take();
}

}  // namespace foam::texgen
