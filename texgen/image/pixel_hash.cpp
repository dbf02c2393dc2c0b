// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/pixel_hash.h"

#include "core/files/file_io.h"
#include "texgen/image/channel_row.h"
#include "texgen/image/half_bits.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

static_assert(std::endian::native == std::endian::little,
              "samples are hashed in little-endian order");

/// Computes the XXH3-128 hash of all data that have been added.
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

    /// Returns the hash as 32 hexadecimal digits.
    std::string digits() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
    }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

std::string block_line(std::string_view names, const ChannelGroup& group) {
    constexpr std::array<std::string_view, 5> kTypes = {"u8", "u16", "f16", "f32", "u32"};
    return fmt::format("{} {} {}x{}\n",
                       names,
                       kTypes.at(static_cast<std::size_t>(group.type)),
                       group.width(),
                       group.height());
}

void add_codes(const ChannelGroup& group, Hasher& hasher) {
    hasher.add(block_line(fmt::format("{}", fmt::join(group.names, "")), group));
    std::visit(
        [&](const auto& image) {
            for (int y = image.height() - 1; y >= 0; --y) {
                hasher.add(std::as_bytes(image.row(y)));
            }
        },
        group.samples);
}

/// Adds the samples of one channel, each converted by `convert` to the form that a file stores.
template <class Sample, class Convert>
void add_channel(const Image<Sample>& image, int channel, const Convert& convert, Hasher& hasher) {
    Bytes row(static_cast<std::size_t>(image.width()) * sizeof(decltype(convert(Sample()))));
    for (int y = image.height() - 1; y >= 0; --y) {
        ChannelRow<Sample>(image.view(), y, channel).write(convert, row.data());
        hasher.add(row);
    }
}

void add_numbers(const PictureChannel& channel, Hasher& hasher) {
    const ChannelGroup& group = *channel.group;
    hasher.add(block_line(channel.name, group));
    if (group.type == SampleType::Half) {
        const auto bits = [](float number) { return half_bits(number); };
        add_channel(std::get<Image<float>>(group.samples), channel.index, bits, hasher);
        return;
    }
    std::visit(
        [&]<class Sample>(const Image<Sample>& image) {
            add_channel(
                image, channel.index, [](Sample sample) { return sample; }, hasher);
        },
        group.samples);
}

}  // namespace

std::string pixel_hash(const Picture& picture) {
    Hasher hasher;
    for (const ChannelGroup& group : picture.groups) {
        if (group.has_codes()) {
            add_codes(group, hasher);
        }
    }
    for (const PictureChannel& channel : channels_of(picture)) {
        if (!channel.group->has_codes()) {
            add_numbers(channel, hasher);
        }
    }
    return hasher.digits();
}

std::string text_hash(std::string_view text) {
    Hasher hasher;
    hasher.add(text);
    return hasher.digits();
}

}  // namespace foam::texgen
