// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/existing_frames.h"

#include "texgen/image/file_io.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/manifest/describe.h"
#include "texgen/preset/drawn_images.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <system_error>

namespace foam::texgen {

namespace {

// Returns true if a file exists and has the recorded pixels. Compares the size first, because this
// is fast and most damaged files differ in size.
bool has_recorded_pixels(const ManifestFile& file, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / file.path;
    std::error_code error;
    if (std::filesystem::file_size(path, error) != file.bytes || error) {
        return false;
    }
    try {
        return pixel_hash(read_picture(path)) == file.pixels;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest) {
    const BakedSet* const set = find_same_set(manifest, describe(preset, frames));
    if (set == nullptr) {
        return {};
    }
    // A layered EXR with further maps is not the file that a bake of these maps writes.
    const std::vector<DrawnImage> images = drawn_images(preset);
    const auto is_wanted = [&](const std::string& map) {
        return std::ranges::find(images, map, &DrawnImage::name) != images.end();
    };
    std::set<int> present;
    std::ranges::copy_if(frames, std::inserter(present, present.end()), [&](int frame) {
        return std::ranges::all_of(images, [&](const DrawnImage& image) {
            const ManifestFile* const file = set->find_file(image.name(), frame);
            return file != nullptr && std::ranges::all_of(file->maps, is_wanted) &&
                   has_recorded_pixels(*file, folder);
        });
    });
    return present;
}

}  // namespace foam::texgen
