// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/preview_textures.h"

#include "core/files/file_io.h"
#include "texgen/image/color.h"
#include "texgen/image/primaries.h"
#include "texgen/sheet/map_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace foam::texgen {

namespace {

using Texture = Image<std::uint8_t>;

constexpr double kMaxCode = 255.0;

std::uint8_t to_code(double number) {
    const double clamped = number > 0.0 ? std::min(number, 1.0) : 0.0;  // NaN becomes 0
    return static_cast<std::uint8_t>(std::lround(kMaxCode * clamped));
}

// Returns the channels of an image of the first frame in the order of SceneImage::channels. Codes
// are scaled to numbers from 0 to 1. Colors have the primaries of sRGB.
Image<float> read_channels(const SceneImage& image) {
    const MapFile& file = image.sequence.files.front();
    Picture picture = read_map_frame(file, image.sequence.map.name);
    if (image.is_color()) {
        convert_colors(picture, "", picture.metadata.primaries, Primaries::Srgb);
    }
    const std::vector<PictureChannel> all = channels_of(picture);
    Image<float> pixels(picture.width(), picture.height(), static_cast<int>(image.channels.size()));
    std::vector<double> row(static_cast<std::size_t>(picture.width()));
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        const auto is_wanted = [&](const PictureChannel& channel) {
            return image.has_codes() ? channel.index == static_cast<int>(c)
                                     : channel.name == image.channels[c];
        };
        const auto channel = std::ranges::find_if(all, is_wanted);
        if (channel == all.end()) {
            throw InputError(
                fmt::format("'{}' has no channel {}", file.path.string(), image.channels[c]));
        }
        for (int y = 0; y < picture.height(); ++y) {
            read_numbers(*channel, y, row);
            for (int x = 0; x < picture.width(); ++x) {
                pixels.pixel(x, y)[c] = static_cast<float>(row[static_cast<std::size_t>(x)]);
            }
        }
    }
    return pixels;
}

// The images of the first frame. They are read when they are needed for the first time.
class PreviewImages {
  public:
    explicit PreviewImages(const SceneMaterial& material) : material_(material) {}

    const SceneImage& image(std::size_t index) const { return material_.images[index]; }
    const Image<float>& channels(std::size_t index) {
        auto found = read_.find(index);
        if (found == read_.end()) {
            found = read_.emplace(index, read_channels(image(index))).first;
        }
        return found->second;
    }
    /// Releases the memory of all images. They are read again if they are needed again.
    void clear() { read_.clear(); }

  private:
    const SceneMaterial& material_;
    std::map<std::size_t, Image<float>> read_;
};

template <class Code>
Texture converted(const Image<float>& pixels, int channels, const Code& code_of) {
    Texture texture(pixels.width(), pixels.height(), channels);
    for (int y = 0; y < pixels.height(); ++y) {
        for (int x = 0; x < pixels.width(); ++x) {
            for (int c = 0; c < channels; ++c) {
                texture.pixel(x, y)[static_cast<std::size_t>(c)] =
                    code_of(pixels.pixel(x, y), static_cast<std::size_t>(c));
            }
        }
    }
    return texture;
}

// Returns the colors of an image as sRGB, with a fourth channel for the opacity if `keeps_opacity`
// is true. EXR files store linear light, premultiplied by the opacity if there is one.
Texture colors_of(PreviewImages& frame, std::size_t index, bool keeps_opacity) {
    const SceneImage& image = frame.image(index);
    const bool is_linear = image.samples().color_space != "sRGB";
    const auto code_of = [&](std::span<const float> pixel, std::size_t c) {
        const auto sample = static_cast<double>(pixel[c]);
        if (c == 3 || !is_linear) {
            return to_code(sample);
        }
        const auto opacity = image.is_premultiplied() ? static_cast<double>(pixel[3]) : 1.0;
        const double light = opacity > 0.0 ? sample / opacity : 0.0;
        return to_code(linear_to_srgb(light > 0.0 ? std::min(light, 1.0) : 0.0));
    };
    return converted(frame.channels(index), keeps_opacity ? 4 : 3, code_of);
}

// Returns a texture of one color.
Texture filled(int width, int height, const std::array<std::uint8_t, 3>& color) {
    Texture texture(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::ranges::copy(color, texture.pixel(x, y).begin());
        }
    }
    return texture;
}

// Writes the numbers of a channel into the channel `texture_channel` of a texture.
void copy_numbers(PreviewImages& frame,
                  const SceneChannel& channel,
                  Texture& texture,
                  std::size_t texture_channel) {
    const Image<float>& numbers = frame.channels(channel.image);
    const double scale = frame.image(channel.image).scale.at(channel.channel);
    const double bias = frame.image(channel.image).bias.at(channel.channel);
    for (int y = 0; y < texture.height(); ++y) {
        for (int x = 0; x < texture.width(); ++x) {
            const auto number = static_cast<double>(numbers.pixel(x, y)[channel.channel]);
            texture.pixel(x, y)[texture_channel] = to_code(scale * number + bias);
        }
    }
}

Texture with_opacity(const Texture& colors, PreviewImages& frame, const SceneChannel& opacity) {
    Texture texture(colors.width(), colors.height(), 4);
    for (int y = 0; y < colors.height(); ++y) {
        for (int x = 0; x < colors.width(); ++x) {
            std::ranges::copy(colors.pixel(x, y), texture.pixel(x, y).begin());
        }
    }
    copy_numbers(frame, opacity, texture, 3);
    return texture;
}

// Returns white pixels with the opacity of a channel.
Texture white_texture(PreviewImages& frame, const SceneChannel& opacity) {
    const Image<float>& numbers = frame.channels(opacity.image);
    return with_opacity(filled(numbers.width(), numbers.height(), {255, 255, 255}), frame, opacity);
}

std::optional<Texture> color_texture(const SceneMaterial& material, PreviewImages& frame) {
    const auto index = material.base_color ? material.base_color : material.lit;
    if (!index) {
        return material.opacity ? std::optional(white_texture(frame, *material.opacity))
                                : std::nullopt;
    }
    const bool has_own_opacity = material.opacity && material.opacity->image == *index &&
                                 material.images[*index].samples().alpha != "none";
    Texture colors = colors_of(frame, *index, has_own_opacity);
    return material.opacity && !has_own_opacity ? with_opacity(colors, frame, *material.opacity)
                                                : std::move(colors);
}

Texture normal_texture(PreviewImages& frame, std::size_t index) {
    const SceneImage& image = frame.image(index);
    return converted(frame.channels(index), 3, [&](std::span<const float> pixel, std::size_t c) {
        const double number = image.scale.at(c) * static_cast<double>(pixel[c]) + image.bias.at(c);
        return to_code((number + 1.0) / 2.0);
    });
}

// Returns occlusion, roughness and metalness, as glTF packs them.
std::optional<Texture> surface_texture(const SceneMaterial& material, PreviewImages& frame) {
    const std::array packed = {material.occlusion, material.roughness, material.metallic};
    std::optional<Texture> texture;
    for (std::size_t c = 0; c < packed.size(); ++c) {
        if (packed.at(c)) {
            const Image<float>& numbers = frame.channels(packed.at(c)->image);
            if (!texture) {
                texture = filled(numbers.width(), numbers.height(), {255, 255, 0});
            }
            copy_numbers(frame, *packed.at(c), *texture, c);
        }
    }
    return texture;
}

}  // namespace

PreviewTextures preview_textures(const SceneMaterial& material) {
    PreviewImages frame(material);
    PreviewTextures textures;
    textures.color = color_texture(material, frame);
    frame.clear();
    if (material.lit) {
        return textures;  // other textures have no effect
    }
    if (material.emission) {
        textures.emission = colors_of(frame, *material.emission, false);
        frame.clear();
    }
    if (material.normal) {
        textures.normal = normal_texture(frame, *material.normal);
        frame.clear();
    }
    textures.surface = surface_texture(material, frame);
    return textures;
}

}  // namespace foam::texgen
