// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/source_picture.h"

#include "core/files/file_io.h"
#include "texgen/image/memory.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kFull = 65535.0;  // the sample of full light and of full opacity

std::uint16_t sample_of(double value) {
    // The comparison replaces NaN by 0.
    return static_cast<std::uint16_t>(
        std::lround((value > 0.0 ? std::min(value, 1.0) : 0.0) * kFull));
}

// The channels of a picture that hold its light and its opacity.
struct LightChannels {
    std::array<PictureChannel, 3>
        light;  // red, green and blue; all the same if the picture is gray
    std::optional<PictureChannel> opacity;
};

std::optional<PictureChannel> find_channel(const std::vector<PictureChannel>& channels,
                                           std::string_view name) {
    const auto found = std::ranges::find(channels, name, &PictureChannel::name);
    return found == channels.end() ? std::nullopt : std::optional(*found);
}

LightChannels light_channels(const Picture& picture, const std::filesystem::path& path) {
    const std::vector<PictureChannel> channels = channels_of(picture);
    const auto red = find_channel(channels, "R");
    const auto green = find_channel(channels, "G");
    const auto blue = find_channel(channels, "B");
    const auto gray = find_channel(channels, "Y");
    if (red && green && blue) {
        return {{*red, *green, *blue}, find_channel(channels, "A")};
    }
    if (gray) {
        return {{*gray, *gray, *gray}, find_channel(channels, "A")};
    }
    throw InputError(
        fmt::format("cannot use '{}': it has neither the channel Y nor the channels R, G and B",
                    path.string()));
}

// Returns a table that gives, for each code of a sample type, the sample of its linear light. With
// the table, each code is converted only once, although many pixels may have it.
std::vector<std::uint16_t> light_of_codes(SampleType type) {
    std::vector<std::uint16_t> samples(type == SampleType::Uint8 ? 256 : 65536);
    const double last = static_cast<double>(samples.size() - 1);
    for (std::size_t code = 0; code < samples.size(); ++code) {
        samples[code] = sample_of(srgb_to_linear(static_cast<double>(code) / last));
    }
    return samples;
}

// Converts one row of numbers to samples of light.
class RowReader {
  public:
    explicit RowReader(const Picture& picture)
        : numbers_(static_cast<std::size_t>(picture.width())) {
        if (picture.groups.front().has_codes()) {
            light_of_codes_ = light_of_codes(picture.groups.front().type);
        }
    }

    // Writes the opacities of a row to channel 3 of `pixels`. Without a channel of opacity, all
    // pixels are opaque.
    void read_opacity(const std::optional<PictureChannel>& channel,
                      int row,
                      std::span<std::uint16_t> pixels) {
        std::fill(numbers_.begin(), numbers_.end(), 1.0);
        if (channel) {
            read_numbers(*channel, row, numbers_);
        }
        for (std::size_t x = 0; x < numbers_.size(); ++x) {
            pixels[4 * x + 3] = sample_of(numbers_[x]);
        }
    }

    // Writes the light of a row to channel `target` of `pixels`. Precondition: read_opacity has
    // written the opacities of the row.
    void read_light(const PictureChannel& channel,
                    int row,
                    std::size_t target,
                    std::span<std::uint16_t> pixels) {
        read_numbers(channel, row, numbers_);
        for (std::size_t x = 0; x < numbers_.size(); ++x) {
            const double opacity = pixels[4 * x + 3] / kFull;
            pixels[4 * x + target] = light_of_codes_.empty()
                                         ? sample_of(opacity > 0.0 ? numbers_[x] / opacity : 0.0)
                                         : light_of_code(numbers_[x]);
        }
    }

  private:
    std::uint16_t light_of_code(double encoded) const {
        const double last = static_cast<double>(light_of_codes_.size() - 1);
        return light_of_codes_[static_cast<std::size_t>(std::lround(encoded * last))];
    }

    std::vector<std::uint16_t> light_of_codes_;  // empty if the numbers are linear light
    std::vector<double> numbers_;
};

}  // namespace

SourcePixel pixel_of(const SourcePicture& picture, int x, int y) {
    const std::span<const std::uint16_t> pixel = picture.pixels.pixel(x, y);
    return {{pixel[0] / kFull, pixel[1] / kFull, pixel[2] / kFull}, pixel[3] / kFull};
}

LinearRgb color_on_white(const SourcePixel& pixel) {
    return mixed({1.0, 1.0, 1.0}, pixel.color, pixel.opacity);
}

double luminance_of(const LinearRgb& color) {
    return std::clamp(0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b, 0.0, 1.0);
}

SourcePicture source_picture_of(const Picture& picture, const std::filesystem::path& path) {
    const LightChannels channels = light_channels(picture, path);
    const auto pixels =
        static_cast<std::uint64_t>(picture.width()) * static_cast<std::uint64_t>(picture.height());
    require_memory(8 * pixels,
                   fmt::format("the picture '{}' of {} x {} pixels",
                               path.string(),
                               picture.width(),
                               picture.height()));
    SourcePicture source{{picture.width(), picture.height(), 4}};
    RowReader reader(picture);
    for (int row = 0; row < picture.height(); ++row) {
        const std::span<std::uint16_t> row_pixels = source.pixels.row(row);
        reader.read_opacity(channels.opacity, row, row_pixels);
        for (std::size_t k = 0; k < channels.light.size(); ++k) {
            reader.read_light(channels.light[k], row, k, row_pixels);
        }
    }
    return source;
}

}  // namespace foam::texgen
