// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/written_file.h"
#include "texgen/image/picture.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/maps/drawn_image.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns true if a foam in the domain gives images that tile. This is the case if the domain is a
/// torus whose shear is a multiple of its width, up to rounding errors.
bool tiles(const Domain& domain);

/// Writes the files of a bake. Thread-safe: all functions may be called from several threads
/// at once.
class FrameFiles {
  public:
    /// Keeps a reference to the preset. Throws std::invalid_argument if its file pattern is
    /// malformed.
    explicit FrameFiles(const Preset& preset);

    /// Returns the paths of the files of a frame. A vector format has one file per drawing, table
    /// or mesh. An image format has one file per image (drawn_images), or one file for all images
    /// (FilePattern::stores_all_maps_in_one_file).
    std::vector<std::filesystem::path> paths(int frame) const;

    /// Returns true if the files are vector files.
    bool is_vector() const { return pattern_.is_vector(); }

    /// Writes the vector files of a frame. Creates missing folders. Returns descriptions of the
    /// files, in the order of `paths`. Throws as encode_vector does, and OutputError if a file
    /// cannot be written. Precondition: is_vector().
    std::vector<WrittenFile> write_vectors(const SimulatedFrame& shown) const;

    /// Draws all images of a frame and writes their files. Creates missing folders. Returns
    /// descriptions of the files, in the order of `paths`. Throws OutputError if a file cannot be
    /// written. Precondition: the files are images.
    std::vector<WrittenFile> write(ShownLayers& shown) const;

    /// Returns which optional images of the distance field (DistanceField) the maps need.
    DistanceNeeds needed_distance() const;

    /// Returns true if drawing the maps of a frame also needs the frame after it.
    bool needs_next() const;

  private:
    WrittenFile write_images(std::span<const DrawnImage> images, ShownLayers& shown) const;
    Picture picture_of(std::span<const DrawnImage> images,
                       ShownLayers& shown,
                       WrittenFile& written) const;
    std::optional<double> displacement_of(const DrawnImage& image, const ShownLayers& shown) const;
    ImageMetadata metadata_of(std::span<const DrawnImage> images) const;
    std::filesystem::path path(std::string_view word, int frame) const;

    const Preset& preset_;
    FilePattern pattern_;
    std::vector<DrawnImage> images_;      // empty for vector files
    std::vector<std::string> map_names_;  // names of the maps that the images show
    ImageMetadata metadata_;              // common to all files
};

}  // namespace foam::texgen
