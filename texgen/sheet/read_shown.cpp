#include "texgen/image/color.h"
#include "texgen/image/png.h"
#include "texgen/sheet/exr_frame.h"
#include "texgen/sheet/shown_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kColors = 3;

bool is_light_in(const ManifestMap& map) {
    return map.samples->color_space != "data";
}

/// What every code of a sample stands for.
template <class Sample>
std::vector<float> values_of_codes(bool is_light) {
    constexpr std::size_t kCodes = std::size_t{std::numeric_limits<Sample>::max()} + 1;
    std::vector<float> values(kCodes);
    for (std::size_t k = 0; k < kCodes; ++k) {
        const double value = static_cast<double>(k) / static_cast<double>(kCodes - 1);
        values[k] = static_cast<float>(is_light ? srgb_to_linear(value) : value);
    }
    return values;
}

template <class Sample>
ShownFrame shown(const Image<Sample>& image, bool is_light) {
    const std::vector<float> values = values_of_codes<Sample>(is_light);
    const bool has_alpha = image.channels() % 2 == 0;
    const float ground = values[kGround * (values.size() - 1) / 255];
    ShownFrame frame{Image<float>(image.width(), image.height(), kColors), is_light};
    const auto from = image.samples();
    const auto step = static_cast<std::size_t>(image.channels());
    const std::size_t next = step >= kColors ? 1 : 0;  // the same for all colours where it is grey
    float* to = frame.pixels.samples().data();
    for (std::size_t k = 0; k < from.size(); k += step) {
        const float opacity = has_alpha ? static_cast<float>(from[k + step - 1]) /
                                              static_cast<float>(values.size() - 1)
                                        : 1.0F;
        for (std::size_t c = 0; c < kColors; ++c) {
            *to++ = opacity * values[from[k + c * next]] + (1.0F - opacity) * ground;
        }
    }
    return frame;
}

using Plane = Image<float>;

const Plane* find_plane(const ExrImage& image, std::string_view name) {
    const auto found = std::ranges::find(image.channels, name, &ExrPlane::name);
    return found != image.channels.end() ? std::get_if<Plane>(&found->pixels) : nullptr;
}

/// Red, green and blue: of grey all the same; nothing is shown as black.
std::array<const Plane*, kColors> planes_shown(const ExrImage& image) {
    if (const Plane* const grey = find_plane(image, "Y"); image.channels.size() == 1) {
        return {grey, grey, grey};
    }
    const bool is_color = find_plane(image, "R") != nullptr;
    return {find_plane(image, is_color ? "R" : "X"),
            find_plane(image, is_color ? "G" : "Y"),
            find_plane(image, is_color ? "B" : "Z")};
}

/// From 0 to 1, what is no number as 0.
float held(double value) {
    return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
}

void fill_channel(Image<float>& pixels, int channel, const Plane& plane, const auto& value_of) {
    const auto from = plane.samples();
    float* to = pixels.samples().data() + channel;
    for (const float sample : from) {
        *to = held(value_of(sample));
        to += kColors;
    }
}

/// Light is there already, multiplied by its opacity.
void add_ground(Image<float>& pixels, const Plane& opacity) {
    const auto ground = static_cast<float>(srgb_to_linear(kGround / 255.0));
    float* to = pixels.samples().data();
    for (const float covered : opacity.samples()) {
        for (int c = 0; c < kColors; ++c) {
            *to++ += (1.0F - held(covered)) * ground;
        }
    }
}

[[noreturn]] void refuse(const MapFile& file, std::string_view reason) {
    throw InputError(fmt::format("'{}' cannot be shown: {}", file.path.string(), reason));
}

ShownFrame shown_exr(const MapFile& file, const ManifestMap& map) {
    const ExrImage image = read_exr_frame(file, map.name);
    const std::array<const Plane*, kColors> planes = planes_shown(image);
    const bool is_light = is_light_in(map);
    if (planes.front() == nullptr) {
        refuse(file, "it has neither Y, nor R, nor X");
    }
    if (!is_light && !map.samples->range) {
        refuse(file, "the manifest does not tell the range of its numbers");
    }
    const std::array<double, 2> range = map.samples->range.value_or(std::array{0.0, 1.0});
    const auto shown_value = [low = range[0], scale = 1.0 / (range[1] - range[0])](float sample) {
        return (sample - low) * scale;
    };
    ShownFrame frame{Image<float>(planes[0]->width(), planes[0]->height(), kColors), is_light};
    for (int c = 0; c < kColors; ++c) {
        if (const Plane* const plane = planes.at(static_cast<std::size_t>(c))) {
            fill_channel(frame.pixels, c, *plane, shown_value);
        }
    }
    if (const Plane* const opacity = find_plane(image, "A"); is_light && opacity != nullptr) {
        add_ground(frame.pixels, *opacity);
    }
    return frame;
}

ShownFrame shown_png(const MapFile& file, const ManifestMap& map) {
    return std::visit([&](const auto& image) { return shown(image, is_light_in(map)); },
                      read_png_samples(file.path));
}

}  // namespace

ShownFrame read_shown(const MapFile& file, const ManifestMap& map) {
    if (file.path.extension() == ".exr") {
        return shown_exr(file, map);
    }
    if (file.path.extension() == ".png") {
        return shown_png(file, map);
    }
    refuse(file, "it is neither a PNG nor an EXR");
}

}  // namespace foam::texgen
