#pragma once

#include "texgen/bake/file_pattern.h"
#include "texgen/bake/written_file.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace foam::texgen {

/// Whether images of a torus tile: under shear, only where it is that of a rectangle again.
bool tiles(const Domain& domain);

/// The image files of a bake. Its functions may be called from several threads at once.
class FrameFiles {
  public:
    /// Keeps the preset in hand.
    explicit FrameFiles(const Preset& preset);

    /// Of one frame.
    std::vector<std::filesystem::path> paths(int frame) const;

    /// Draws every map of a frame and writes it; folders are made as needed. The files are those of
    /// `paths`, in that order. Throws OutputError.
    std::vector<WrittenFile> write(ShownLayers& shown);

    /// What the maps ask of distances, and whether of the next frame.
    DistanceNeeds distance() const;
    bool needs_next() const;

  private:
    WrittenFile write_png(const Map& map, const MapImage& image, const std::filesystem::path& path);
    WrittenFile write_exr(std::span<const Map* const> maps,
                          ShownLayers& shown,
                          const std::filesystem::path& path) const;
    std::filesystem::path path(const Map& map, int frame) const;

    std::unique_ptr<PngEncoder> take_encoder();
    void give_back(std::unique_ptr<PngEncoder> encoder);

    PngMetadata png_metadata(const Map& map, bool color) const;
    ExrMetadata exr_metadata(std::span<const Map* const> maps, bool color) const;

    const Preset& preset_;
    FilePattern pattern_;
    std::vector<const Map*> maps_;
    PngMetadata png_;
    ExrMetadata exr_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<PngEncoder>> idle_encoders_;  // at most one for every thread
};

}  // namespace foam::texgen
