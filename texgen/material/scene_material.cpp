// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_material.h"

#include "core/files/file_io.h"
#include "texgen/material/identifier.h"
#include "texgen/material/scene_sources.h"
#include "texgen/preset/drawn_images.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace foam::texgen {

namespace {

constexpr double kSameDisplacement = 1e-9;  // largest relative difference that counts as equal
constexpr std::size_t kAlpha = 3;           // index of the opacity in an image of colors

std::vector<std::string> words_in(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

// Adds images to a material when they are needed. An argument `drawn` is the index of an image in
// drawn_images(preset).
class MaterialBuilder {
  public:
    MaterialBuilder(const Preset& preset, const BakedSet& set, const std::filesystem::path& folder)
        : set_(set), folder_(folder) {
        for (const DrawnImage& image : drawn_images(preset)) {
            names_.emplace_back(image.name());
        }
        indices_.resize(names_.size());
    }

    // Chooses the frames of which all used images exist.
    void choose_frames(const std::vector<std::size_t>& used) {
        material.frames = set_.frames();
        std::erase_if(material.frames, [&](int frame) {
            return std::ranges::any_of(used, [&](std::size_t image) {
                return set_.find_file(names_[image], frame) == nullptr;
            });
        });
        if (material.frames.empty()) {
            throw InputError(
                fmt::format("'{}' has no frame of preset '{}' with all images of its material",
                            folder_.string(),
                            set_.preset));
        }
    }

    // Returns the index of an image in material.images.
    std::optional<std::size_t> image(std::optional<std::size_t> drawn) {
        return drawn ? std::optional(index_of(*drawn)) : std::nullopt;
    }

    std::optional<SceneChannel> channel(const std::optional<SceneSource>& source) {
        if (!source) {
            return std::nullopt;
        }
        const std::size_t index = index_of(source->image);
        if (source->inverted) {
            material.images[index].scale.at(source->channel) = -1.0;
            material.images[index].bias.at(source->channel) = 1.0;
        }
        return SceneChannel{index, source->channel};
    }

    // Sets the scale and the bias of the image of normals. They convert its samples to normals with
    // y up, whose x, y and z are from -1 to 1.
    void scale_normals() {
        SceneImage& image = material.images[*material.normal];
        const bool has_codes = image.has_codes();
        for (std::size_t c = 0; c < 3; ++c) {
            const double sign = c == 1 && material.is_normal_down ? -1.0 : 1.0;
            image.scale.at(c) = has_codes ? 2.0 * sign : sign;
            image.bias.at(c) = has_codes ? -sign : 0.0;
        }
    }

    void measure_displacements() {
        const std::string& map = material.images[material.height->image].sequence.map.name;
        for (const int frame : material.frames) {
            material.displacements.push_back(
                kPlaneWidth * set_.find_file(map, frame)->displacement.value_or(0.0));
        }
    }

    SceneMaterial material;

  private:
    std::size_t index_of(std::size_t drawn) {
        if (!indices_[drawn]) {
            indices_[drawn] = material.images.size();
            material.images.push_back(load(names_[drawn]));
        }
        return *indices_[drawn];
    }

    SceneImage load(const std::string& name) {
        SceneImage image{.id = ids_.unique("image_" + name),
                         .sequence = map_sequence(set_, folder_, name, material.frames),
                         .paths = {},
                         .channels = {}};
        image.channels = words_in(image.samples().channels);
        for (const int frame : material.frames) {
            image.paths.push_back(set_.find_file(name, frame)->path);
        }
        material.tiles = material.tiles && image.sequence.tiles();
        return image;
    }

    const BakedSet& set_;
    const std::filesystem::path& folder_;
    std::vector<std::string> names_;                   // the names of the drawn images
    std::vector<std::optional<std::size_t>> indices_;  // their indices in material.images
    Identifiers ids_;
};

std::vector<std::size_t> used_images(const SceneSources& sources) {
    std::vector<std::size_t> used;
    for (const auto& image : {sources.base_color, sources.lit, sources.emission, sources.normal}) {
        if (image) {
            used.push_back(*image);
        }
    }
    for (const auto& number : {sources.roughness,
                               sources.metallic,
                               sources.occlusion,
                               sources.opacity,
                               sources.height}) {
        if (number) {
            used.push_back(number->image);
        }
    }
    return used;
}

}  // namespace

bool SceneMaterial::has_one_displacement() const {
    return std::ranges::all_of(displacements, [&](double displacement) {
        return std::abs(displacement - displacements.front()) <=
               kSameDisplacement * displacements.front();
    });
}

SceneMaterial scene_material(const Preset& preset,
                             const BakedSet& set,
                             const std::filesystem::path& folder) {
    const SceneSources sources = scene_sources(preset);
    MaterialBuilder builder(preset, set, folder);
    builder.choose_frames(used_images(sources));
    SceneMaterial& material = builder.material;
    material.id = identifier(set.preset);
    material.preset = set.preset;
    material.description = set.description;
    material.plane_height = kPlaneWidth * set.height / set.width;
    material.frames_per_second = set.frames_per_second;
    material.base_color = builder.image(sources.base_color);
    material.lit = builder.image(sources.lit);
    material.emission = builder.image(sources.emission);
    material.normal = builder.image(sources.normal);
    material.is_normal_down = sources.is_normal_down;
    material.roughness = builder.channel(sources.roughness);
    material.metallic = builder.channel(sources.metallic);
    material.occlusion = builder.channel(sources.occlusion);
    material.height = builder.channel(sources.height);
    const auto color = material.base_color ? material.base_color : material.lit;
    if (color && material.images[*color].samples().alpha != "none") {
        material.opacity = SceneChannel{*color, kAlpha};
    } else if (!material.tiles) {
        material.opacity = builder.channel(sources.opacity);  // images that tile are opaque
    }
    if (material.normal) {
        builder.scale_normals();
    }
    if (material.height) {
        builder.measure_displacements();
    }
    return material;
}

}  // namespace foam::texgen
