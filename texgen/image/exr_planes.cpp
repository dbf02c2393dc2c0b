// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr_planes.h"

#include "core/parallel/simd_level.h"
#include "texgen/image/channel_row.h"
#include "texgen/image/half_bits.h"
#include "texgen/image/mip_level.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace foam::texgen {

namespace {

constexpr float kHalfLimit = 65520.0F;  // the smallest number whose half float is infinite

// Throws std::invalid_argument if a number of the row is not finite, or would be infinite in the
// type that the file has for the channel.
void check_numbers(const ChannelRow<float>& row, const ExrChannel& channel) {
    const float limit =
        channel.type == SampleType::Half ? kHalfLimit : std::numeric_limits<float>::infinity();
    const bool is_valid = at_simd_level([row, limit] {
        unsigned outside = 0;
        for (std::size_t x = 0; x < row.count; ++x) {
            outside |= static_cast<unsigned>(!(std::abs(row.first[x * row.step]) < limit));
        }
        return outside == 0;
    });
    for (std::size_t x = 0; !is_valid && x < row.count; ++x) {
        if (const float number = row.first[x * row.step]; !(std::abs(number) < limit)) {
            reject_exr(fmt::format("channel '{}' cannot store the value {}", channel.name, number));
        }
    }
}

// Returns the samples of a channel, each converted by `convert`, with the top row first.
template <class Sample, class Convert>
Bytes stored_rows(const ExrChannel& channel, const Convert& convert) {
    const auto& view = std::get<ImageView<const Sample>>(channel.pixels);
    const std::size_t row_bytes =
        static_cast<std::size_t>(view.width()) * sizeof(decltype(convert(Sample())));
    Bytes rows(row_bytes * static_cast<std::size_t>(view.height()));
    std::byte* to = rows.data();
    for (int y = view.height() - 1; y >= 0; --y, to += row_bytes) {
        const ChannelRow<Sample> row(view, y, channel.channel_index);
        if constexpr (std::is_floating_point_v<Sample>) {
            check_numbers(row, channel);
        }
        row.write(convert, to);
    }
    return rows;
}

Bytes stored_rows(const ExrChannel& channel) {
    const auto unchanged = [](auto number) { return number; };
    if (channel.type == SampleType::Uint32) {
        return stored_rows<std::uint32_t>(channel, unchanged);
    }
    if (channel.type == SampleType::Half) {
        return stored_rows<float>(channel, [](float number) { return half_bits(number); });
    }
    return stored_rows<float>(channel, unchanged);
}

using Level = std::variant<Image<float>, Image<std::uint32_t>>;

Level smaller_level(const ExrChannel& channel) {
    if (const auto* view = std::get_if<ImageView<const float>>(&channel.pixels)) {
        return mean_level(*view, channel.channel_index);
    }
    return central_level(std::get<ImageView<const std::uint32_t>>(channel.pixels),
                         channel.channel_index);
}

}  // namespace

ExrSize size_of(const ExrChannel& channel) {
    return std::visit(
        [](const auto& view) {
            return ExrSize{view.width(), view.height()};
        },
        channel.pixels);
}

Imf::PixelType pixel_type(SampleType type) {
    switch (type) {
        case SampleType::Half:
            return Imf::HALF;
        case SampleType::Float:
            return Imf::FLOAT;
        case SampleType::Uint32:
            return Imf::UINT;
        default:
            reject_exr(fmt::format("samples of type {} are not supported", name_of(type)));
    }
}

void reject_exr(const std::string& why) {
    throw std::invalid_argument("cannot encode an EXR: " + why);
}

std::vector<ExrChannel> exr_channels(const Picture& picture) {
    std::vector<ExrChannel> channels;
    for (const PictureChannel& channel : channels_of(picture)) {
        ExrChannel& added = channels.emplace_back();
        added.name = channel.name;
        added.type = channel.group->type;
        added.channel_index = channel.index;
        if (const auto* ids = std::get_if<Image<std::uint32_t>>(&channel.group->samples)) {
            added.pixels = ids->view();
        } else if (const auto* numbers = std::get_if<Image<float>>(&channel.group->samples)) {
            added.pixels = numbers->view();
        } else {
            reject_exr(fmt::format("samples of type {} are not supported", name_of(added.type)));
        }
    }
    return channels;
}

ExrPlanes::ExrPlanes(std::span<const ExrChannel> channels) : size_(size_of(channels.front())) {
    for (const ExrChannel& channel : channels) {
        Bytes samples = stored_rows(channel);
        const std::size_t row_bytes = samples.size() / static_cast<std::size_t>(size_.height);
        planes_.push_back({channel.name, channel.type, std::move(samples), row_bytes});
    }
    std::ranges::sort(planes_, {}, &ExrPlane::name);
}

Imf::FrameBuffer ExrPlanes::buffer() {
    Imf::FrameBuffer buffer;
    for (ExrPlane& plane : planes_) {
        const std::size_t pixel = plane.row_bytes / static_cast<std::size_t>(size_.width);
        auto* const first = reinterpret_cast<char*>(plane.samples.data());
        buffer.insert(plane.name,
                      Imf::Slice(pixel_type(plane.type), first, pixel, plane.row_bytes));
    }
    return buffer;
}

void ExrLevels::advance() {
    std::vector<Level> smaller;
    for (const ExrChannel& channel : channels_) {
        smaller.push_back(smaller_level(channel));
    }
    levels_ = std::move(smaller);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        channels_[k].channel_index = 0;
        std::visit([&](const auto& level) { channels_[k].pixels = level.view(); }, levels_[k]);
    }
}

}  // namespace foam::texgen
