#pragma once

#include "texgen/bake/file_pattern.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The files of a bake's maps, one frame at a time.
class MapFiles {
  public:
    /// Borrows the preset. Throws std::invalid_argument for a pattern that FilePattern refuses.
    explicit MapFiles(const Preset& preset);

    /// One per map, in the order of the preset.
    std::vector<std::filesystem::path> paths(int frame) const;

    /// Draws the maps of a frame and writes them; folders are made as needed. May be called from
    /// several threads. Throws OutputError.
    void write(FrameLayers& layers, int frame) const;

    /// What the maps ask of distances, and whether of the next frame.
    DistanceNeeds distance() const;
    bool needs_next() const;

  private:
    using Texts = std::vector<std::pair<std::string, std::string>>;

    void write_png_of(const Map& map, const MapImage& image, int frame) const;
    Texts texts_of(const Map& map) const;

    const Preset& preset_;
    FilePattern pattern_;
    std::vector<const Map*> maps_;
    Texts texts_;
};

}  // namespace foam::texgen
