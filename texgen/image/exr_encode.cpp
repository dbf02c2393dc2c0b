// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/parallel_for.h"
#include "texgen/image/exr.h"
#include "texgen/image/exr_planes.h"
#include "texgen/image/exr_stream.h"
#include "texgen/image/exr_zip.h"
#include "texgen/image/primaries.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfVersion.h>
#include <OpenEXR/ImfXdr.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr int kTileSide = 64;
// The largest length of a name in characters. Old readers reject longer names of attributes and
// channels.
constexpr std::size_t kMaxNameLength = 31;

// Names of optional attributes of EXR. The keyword of a text must not be one of these names,
// because readers would take the text for the attribute. Attributes that the header already has,
// such as the required ones, need not be listed, because is_text_name also searches the header.
constexpr std::array<std::string_view, 7> kReservedNames = {
    "chromaticities", "wrapmodes", "framesPerSecond", "name", "type", "view", "chunkCount"};

int channels_of(const ExrChannel& channel) {
    return std::visit([](const auto& view) { return view.channels(); }, channel.pixels);
}

void check_channel(const ExrChannel& channel, const ExrSize& size) {
    const bool integers = std::holds_alternative<ImageView<const std::uint32_t>>(channel.pixels);
    if (channel.name.empty()) {
        reject_exr("a channel has no name");
    }
    if (size_of(channel) != size) {
        reject_exr(
            fmt::format("channel '{}' has a different size than the first channel", channel.name));
    }
    if (channel.channel_index < 0 || channel.channel_index >= channels_of(channel)) {
        reject_exr(fmt::format("the channel index of channel '{}' is {}, but must be from 0 to {}",
                               channel.name,
                               channel.channel_index,
                               channels_of(channel) - 1));
    }
    if (integers != (channel.type == SampleType::Uint32)) {
        reject_exr(
            fmt::format("channel '{}' has a different sample type than its pixels", channel.name));
    }
}

void check_channels(std::span<const ExrChannel> channels) {
    if (channels.empty() || size_of(channels.front()).width < 1) {
        reject_exr("an image needs at least one channel and one pixel");
    }
    std::set<std::string> names;
    for (const ExrChannel& channel : channels) {
        check_channel(channel, size_of(channels.front()));
        if (!names.insert(channel.name).second) {
            reject_exr(fmt::format("duplicate channel '{}'", channel.name));
        }
    }
}

Imf::Compression compression_of(ExrCompression compression) {
    constexpr std::array<Imf::Compression, 5> kKinds = {Imf::NO_COMPRESSION,
                                                        Imf::RLE_COMPRESSION,
                                                        Imf::ZIPS_COMPRESSION,
                                                        Imf::ZIP_COMPRESSION,
                                                        Imf::PIZ_COMPRESSION};
    return kKinds.at(static_cast<std::size_t>(compression));
}

/// Returns true if a text attribute with this name can be added to the header.
bool is_text_name(const Imf::Header& header, const std::string& name) {
    return !name.empty() && name.size() <= kMaxNameLength && header.find(name) == header.end() &&
           std::ranges::find(kReservedNames, name) == kReservedNames.end();
}

void add_texts(Imf::Header& header, const ImageMetadata& metadata) {
    for (const auto& [name, text] : metadata.text) {
        if (!is_text_name(header, name)) {
            reject_exr(fmt::format("'{}' cannot be the name of a text attribute", name));
        }
        header.insert(name, Imf::StringAttribute(text));
    }
}

Imf::Chromaticities attribute_of(const Chromaticities& colors) {
    const auto point = [](const Chromaticity& color) {
        return Imath::V2f(static_cast<float>(color.x), static_cast<float>(color.y));
    };
    return {point(colors.red), point(colors.green), point(colors.blue), point(colors.white)};
}

Imf::Header header_of(std::span<const ExrChannel> channels,
                      const ImageMetadata& metadata,
                      const ExrEncoding& encoding) {
    const ExrSize size = size_of(channels.front());
    Imf::Header header(size.width, size.height);
    header.compression() = compression_of(encoding.compression);
    header.zipCompressionLevel() = encoding.zip_level;
    for (const ExrChannel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(pixel_type(channel.type)));
    }
    if (encoding.mip_levels) {
        header.setTileDescription({kTileSide, kTileSide, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    }
    if (metadata.color) {
        Imf::addChromaticities(header, attribute_of(chromaticities_of(metadata.primaries)));
    }
    if (metadata.periodic) {
        Imf::addWrapmodes(header, "periodic");
    }
    if (const auto& rate = metadata.frame_rate) {
        Imf::addFramesPerSecond(header, Imf::Rational(rate->frames, rate->seconds));
    }
    add_texts(header, metadata);
    return header;
}

/// Returns the number of threads of OpenEXR's thread pool that one file may use. The result 0 means
/// that only the caller's thread is used. All files of the process share the pool. Enlarges the
/// pool if it has fewer threads than requested. `threads` is ExrEncoding::threads.
int library_threads(int threads) {
    static std::mutex mutex;
    if (threads == 1) {
        return 0;
    }
    const int wanted = thread_count(threads);
    const std::scoped_lock lock(mutex);
    if (Imf::globalThreadCount() < wanted) {
        Imf::setGlobalThreadCount(wanted);
    }
    return wanted;
}

void write_rows(std::span<const ExrChannel> channels,
                const Imf::Header& header,
                int threads,
                Imf::OStream& stream) {
    ExrPlanes planes(channels);
    Imf::OutputFile file(stream, header, threads);
    file.setFrameBuffer(planes.buffer());
    file.writePixels(header.dataWindow().max.y + 1);
}

// Returns true if the name of a channel is longer than old readers accept.
bool has_long_names(std::span<const ExrChannel> channels) {
    return std::ranges::any_of(
        channels, [](const ExrChannel& channel) { return channel.name.size() > kMaxNameLength; });
}

// Returns an EXR that stores rows, not tiles, with the compression ZIP or ZIPS.
Bytes encode_zip(std::span<const ExrChannel> channels,
                 const Imf::Header& header,
                 const ExrEncoding& encoding) {
    header.sanityCheck();
    Bytes bytes;
    ExrOutput stream(bytes);
    const int version = Imf::EXR_VERSION | (has_long_names(channels) ? Imf::LONG_NAMES_FLAG : 0);
    Imf::Xdr::write<Imf::StreamIO>(stream, Imf::MAGIC);
    Imf::Xdr::write<Imf::StreamIO>(stream, version);
    header.writeTo(stream);
    const int rows_per_chunk = encoding.compression == ExrCompression::Zip ? 16 : 1;
    append_zip_chunks(
        ExrPlanes(channels), {rows_per_chunk, encoding.zip_level, encoding.threads}, bytes);
    return bytes;
}

void write_levels(std::span<const ExrChannel> channels,
                  const Imf::Header& header,
                  int threads,
                  Imf::OStream& stream) {
    ExrLevels levels(channels);
    Imf::TiledOutputFile file(stream, header, threads);
    for (int level = 0; level < file.numLevels(); ++level) {
        ExrPlanes planes(levels.channels());
        file.setFrameBuffer(planes.buffer());
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        levels.advance();
    }
}

}  // namespace

Bytes encode_exr(std::span<const ExrChannel> channels,
                 const ImageMetadata& metadata,
                 const ExrEncoding& encoding) {
    check_channels(channels);
    const Imf::Header header = header_of(channels, metadata, encoding);
    const bool is_zip =
        encoding.compression == ExrCompression::Zip || encoding.compression == ExrCompression::Zips;
    Bytes bytes;
    ExrOutput stream(bytes);
    try {
        if (is_zip && !encoding.mip_levels) {
            return encode_zip(channels, header, encoding);
        }
        const int threads = library_threads(encoding.threads);
        if (encoding.mip_levels) {
            write_levels(channels, header, threads, stream);
        } else {
            write_rows(channels, header, threads, stream);
        }
    } catch (const Iex::BaseExc& error) {
        throw OutputError(fmt::format("cannot encode an EXR: {}", error.what()));
    }
    return bytes;
}

Bytes encode_exr(const Picture& picture, const ExrEncoding& encoding) {
    return encode_exr(exr_channels(picture), picture.metadata, encoding);
}

}  // namespace foam::texgen
