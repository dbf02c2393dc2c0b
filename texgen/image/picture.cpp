// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace foam::texgen {

namespace {

constexpr std::array<std::string_view, 5> kTypeNames = {
    "uint8", "uint16", "half", "float", "uint32"};

template <class Code>
ChannelGroup group_of(Image<Code> codes, SampleType type) {
    ChannelGroup group{{}, type, {}};
    for (const char letter : code_channel_names(codes.channels())) {
        group.names.emplace_back(1, letter);
    }
    group.samples = std::move(codes);
    return group;
}

/// Returns the sample value that represents the number 1.
template <class Sample>
constexpr double unit_of(SampleType type) {
    if constexpr (std::is_integral_v<Sample>) {
        return type == SampleType::Uint32 ? 1.0 : std::numeric_limits<Sample>::max();
    } else {
        return 1.0;
    }
}

}  // namespace

std::span<const std::string_view> sample_type_names() {
    return kTypeNames;
}

std::string_view name_of(SampleType type) {
    return kTypeNames.at(static_cast<std::size_t>(type));
}

int ChannelGroup::width() const {
    return std::visit([](const auto& image) { return image.width(); }, samples);
}

int ChannelGroup::height() const {
    return std::visit([](const auto& image) { return image.height(); }, samples);
}

int ChannelGroup::channels() const {
    return std::visit([](const auto& image) { return image.channels(); }, samples);
}

std::string_view code_channel_names(int channels) {
    constexpr std::array<std::string_view, 4> kLetters = {"Y", "YA", "RGB", "RGBA"};
    return kLetters.at(static_cast<std::size_t>(channels - 1));
}

ChannelGroup code_channels(Image<std::uint8_t> codes) {
    return group_of(std::move(codes), SampleType::Uint8);
}

ChannelGroup code_channels(Image<std::uint16_t> codes) {
    return group_of(std::move(codes), SampleType::Uint16);
}

std::string_view layer_of(std::string_view channel) {
    const std::size_t dot = channel.rfind('.');
    return channel.substr(0, dot == std::string_view::npos ? 0 : dot);
}

std::vector<const ChannelGroup*> groups_of(const Picture& picture, std::string_view layer) {
    std::vector<const ChannelGroup*> groups;
    for (const ChannelGroup& group : picture.groups) {
        const std::string_view found = layer_of(group.names.front());
        if (found.empty() || found == layer) {
            groups.push_back(&group);
        }
    }
    return groups;
}

std::vector<PictureChannel> channels_of(const Picture& picture) {
    std::vector<PictureChannel> channels;
    for (const ChannelGroup& group : picture.groups) {
        for (int k = 0; k < group.channels(); ++k) {
            channels.push_back({group.names.at(static_cast<std::size_t>(k)), &group, k});
        }
    }
    std::ranges::sort(channels, {}, &PictureChannel::name);
    return channels;
}

void read_numbers(const PictureChannel& channel, int row, std::span<double> to) {
    std::visit(
        [&]<class Sample>(const Image<Sample>& image) {
            assert(to.size() == static_cast<std::size_t>(image.width()));
            const double unit = unit_of<Sample>(channel.group->type);
            const auto step = static_cast<std::size_t>(image.channels());
            const Sample* from = &image.row(row)[static_cast<std::size_t>(channel.index)];
            for (std::size_t x = 0; x < to.size(); ++x) {
                to[x] = static_cast<double>(from[x * step]) / unit;
            }
        },
        channel.group->samples);
}

}  // namespace foam::texgen
