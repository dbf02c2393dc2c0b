// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/existing_frames.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/bake/measurements.h"
#include "texgen/bake/vector_files.h"
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

// Returns the present hash of a file, computed in the same way as the hash in ManifestFile::pixels.
std::string present_hash(const std::filesystem::path& path) {
    return find_vector_format(path.string()) != nullptr ? file_hash(path)
                                                        : pixel_hash(read_picture(path));
}

// Returns true if a file exists and has the hash that the manifest records (ManifestFile::pixels).
// Compares the size of the file with the recorded size first, because this is fast and most damaged
// files have another size.
bool has_recorded_pixels(const ManifestFile& file, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / file.path;
    std::error_code error;
    if (std::filesystem::file_size(path, error) != file.bytes || error) {
        return false;
    }
    try {
        return present_hash(path) == file.pixels;
    } catch (const InputError&) {
        return false;
    }
}

// Returns the names by which BakedSet::find_file finds the files of a frame: the names of the maps
// and packed images, or of the vector files.
std::vector<std::string> names_of(const Preset& preset) {
    if (vector_format_of(preset) != nullptr) {
        return vector_parts(preset);
    }
    std::vector<std::string> names;
    for (const DrawnImage& image : drawn_images(preset)) {
        names.emplace_back(image.name());
    }
    return names;
}

}  // namespace

std::string file_hash(const std::filesystem::path& path) {
    return text_hash(as_text(read_file(path, kImageInput)));
}

std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest) {
    const BakedSet* const set = find_same_set(manifest, describe(preset, frames));
    if (set == nullptr) {
        return {};
    }
    const std::vector<std::string> names = names_of(preset);
    // A file with further maps must be written again: a bake of this preset would write an EXR
    // without their layers.
    const auto is_wanted = [&](const std::string& map) {
        return std::ranges::find(names, map) != names.end();
    };
    std::set<int> existing;
    std::ranges::copy_if(frames, std::inserter(existing, existing.end()), [&](int frame) {
        const FrameStatistics* const statistics = set->find_frame(frame);
        if (!has_measurements(statistics == nullptr ? std::string() : statistics->measurements,
                              preset.output.measurements)) {
            return false;
        }
        return std::ranges::all_of(names, [&](const std::string& name) {
            const ManifestFile* const file = set->find_file(name, frame);
            return file != nullptr && std::ranges::all_of(file->maps, is_wanted) &&
                   has_recorded_pixels(*file, folder);
        });
    });
    return existing;
}

}  // namespace foam::texgen
