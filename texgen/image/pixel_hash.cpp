#include "texgen/image/pixel_hash.h"

#include "texgen/image/picture.h"

#include <Imath/half.h>
#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

static_assert(std::endian::native == std::endian::little, "samples are hashed as they lie there");

class Hasher {
  public:
    Hasher() : state_(XXH3_createState(), XXH3_freeState) {
        if (state_ == nullptr) {
            throw std::bad_alloc();
        }
        XXH3_128bits_reset(state_.get());
    }

    void add(std::span<const std::byte> bytes) {
        XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
    }

    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }

    std::string digits() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
    }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

template <class View>
std::string block_line(std::string_view names, std::string_view type, const View& view) {
    return fmt::format("{} {} {}x{}\n", names, type, view.width(), view.height());
}

template <class Sample>
std::string hash_png(ImageView<const Sample> pixels, std::string_view type) {
    Hasher hasher;
    hasher.add(block_line(png_channel_names(pixels.channels()), type, pixels));
    for (int y = pixels.height() - 1; y >= 0; --y) {
        hasher.add(std::as_bytes(pixels.row(y)));
    }
    return hasher.digits();
}

/// One channel of a view, each sample converted.
template <class Sample, class Convert>
void add_channel(ImageView<const Sample> view,
                 int channel,
                 const Convert& convert,
                 Hasher& hasher) {
    std::vector<decltype(convert(Sample()))> row(static_cast<std::size_t>(view.width()));
    const auto step = static_cast<std::size_t>(view.channels());
    for (int y = view.height() - 1; y >= 0; --y) {
        const Sample* from = &view.row(y)[static_cast<std::size_t>(channel)];
        for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] = convert(from[x * step]);
        }
        hasher.add(std::as_bytes(std::span(row)));
    }
}

void add_channel(const ExrChannel& channel, Hasher& hasher) {
    constexpr std::array<std::string_view, 3> kTypes = {"f16", "f32", "u32"};
    const std::string_view type = kTypes.at(static_cast<std::size_t>(channel.type));
    std::visit([&](const auto& view) { hasher.add(block_line(channel.name, type, view)); },
               channel.pixels);
    if (const auto* ids = std::get_if<ImageView<const std::uint32_t>>(&channel.pixels)) {
        add_channel(
            *ids, channel.channel, [](std::uint32_t id) { return id; }, hasher);
        return;
    }
    const auto numbers = std::get<ImageView<const float>>(channel.pixels);
    if (channel.type == ExrType::Half) {
        const auto bits = [](float number) { return half(number).bits(); };
        add_channel(numbers, channel.channel, bits, hasher);
    } else {
        add_channel(
            numbers, channel.channel, [](float number) { return number; }, hasher);
    }
}

}  // namespace

std::string pixel_hash(ImageView<const std::uint8_t> pixels) {
    return hash_png(pixels, "u8");
}

std::string pixel_hash(ImageView<const std::uint16_t> pixels) {
    return hash_png(pixels, "u16");
}

std::string pixel_hash(std::span<const ExrChannel> channels) {
    std::vector<ExrChannel> sorted(channels.begin(), channels.end());
    std::ranges::sort(sorted, {}, &ExrChannel::name);
    Hasher hasher;
    for (const ExrChannel& channel : sorted) {
        add_channel(channel, hasher);
    }
    return hasher.digits();
}

std::string pixel_hash(const ExrImage& image) {
    std::vector<ExrChannel> channels;
    for (const ExrPlane& plane : image.channels) {
        std::visit(
            [&](const auto& pixels) {
                channels.push_back({plane.name, plane.type, pixels.view(), 0});
            },
            plane.pixels);
    }
    return pixel_hash(channels);
}

std::string text_hash(std::string_view text) {
    Hasher hasher;
    hasher.add(text);
    return hasher.digits();
}

}  // namespace foam::texgen
