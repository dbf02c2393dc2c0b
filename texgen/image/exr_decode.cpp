// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr.h"
#include "texgen/image/exr_header.h"
#include "texgen/image/exr_stream.h"
#include "texgen/image/memory.h"
#include "texgen/image/primaries.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledInputFile.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <string_view>

namespace foam::texgen {

namespace {

// The names of string attributes with which OpenEXR describes the image and the parts of a file.
// These attributes are not returned as texts.
constexpr std::array<std::string_view, 4> kNoTexts = {"wrapmodes", "name", "type", "view"};

SampleType type_of(const Imf::Channel& channel) {
    constexpr std::array<SampleType, Imf::NUM_PIXELTYPES> kTypes = {
        SampleType::Uint32, SampleType::Half, SampleType::Float};
    return kTypes.at(static_cast<std::size_t>(channel.type));
}

using Groups = std::vector<ChannelGroup>;

struct Extent {
    int width;
    int height;
};

/// Returns the width and height in pixels of a data window, the rectangle of pixels that a file or
/// one of its mip levels stores.
Extent extent_of(const Imath::Box2i& window) {
    return {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
}

Groups blank_groups(const Imf::Header& header, const Extent& extent) {
    Groups groups;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const SampleType type = type_of(channel.channel());
        groups.push_back({{channel.name()}, type, {}});
        if (type == SampleType::Uint32) {
            groups.back().samples = Image<std::uint32_t>(extent.width, extent.height, 1);
        } else {
            groups.back().samples = Image<float>(extent.width, extent.height, 1);
        }
    }
    return groups;
}

Imf::FrameBuffer buffer_of(Groups& groups, const Imath::Box2i& window) {
    Imf::FrameBuffer buffer;
    for (ChannelGroup& group : groups) {
        const Imf::PixelType type = group.type == SampleType::Uint32 ? Imf::UINT : Imf::FLOAT;
        void* const first =
            std::visit([](auto& image) -> void* { return image.samples().data(); }, group.samples);
        buffer.insert(group.names.front(), Imf::Slice::Make(type, first, window));
    }
    return buffer;
}

/// Reverses the order of the rows, which run upward in an Image and downward in a file.
template <class Sample>
void flip_rows(Image<Sample>& image) {
    for (int y = 0; 2 * y + 1 < image.height(); ++y) {
        std::ranges::swap_ranges(image.row(y), image.row(image.height() - 1 - y));
    }
}

/// Returns the channels of a data window, one group per channel. `read(buffer)` must read the
/// pixels of the window into a frame buffer.
template <class Read>
Groups read_groups(const Imf::Header& header, const Imath::Box2i& window, const Read& read) {
    Groups groups = blank_groups(header, extent_of(window));
    read(buffer_of(groups, window));
    for (ChannelGroup& group : groups) {
        std::visit([](auto& image) { flip_rows(image); }, group.samples);
    }
    return groups;
}

Groups read_rows(Imf::InputFile& file) {
    const Imath::Box2i window = file.header().dataWindow();
    return read_groups(file.header(), window, [&](const Imf::FrameBuffer& buffer) {
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
    });
}

Groups read_tiles(std::span<const std::byte> content, int level) {
    ExrInput stream(content);
    Imf::TiledInputFile file(stream, 0);
    if (!file.isValidLevel(level, level)) {
        throw InputError(fmt::format("mip level {} does not exist", level));
    }
    const Imath::Box2i window = file.dataWindowForLevel(level);
    return read_groups(file.header(), window, [&](const Imf::FrameBuffer& buffer) {
        file.setFrameBuffer(buffer);
        file.readTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    });
}

/// Returns true if the chromaticities of a file are close to those of `primaries`. They need not be
/// equal, because programs round them to three to five digits, and some programs write D60 instead
/// of the white point of ACES.
bool is_close(const Imf::Chromaticities& found, Primaries primaries) {
    constexpr double kTolerance = 2e-3;
    const Chromaticities wanted = chromaticities_of(primaries);
    const auto is_near = [](const Imath::V2f& point, const Chromaticity& color) {
        return std::abs(static_cast<double>(point.x) - color.x) < kTolerance &&
               std::abs(static_cast<double>(point.y) - color.y) < kTolerance;
    };
    return is_near(found.red, wanted.red) && is_near(found.green, wanted.green) &&
           is_near(found.blue, wanted.blue) && is_near(found.white, wanted.white);
}

ImageMetadata metadata_of(const Imf::Header& header) {
    ImageMetadata metadata;
    metadata.color = Imf::hasChromaticities(header);
    if (metadata.color && is_close(Imf::chromaticities(header), Primaries::AcesCg)) {
        metadata.primaries = Primaries::AcesCg;
    }
    metadata.periodic = Imf::hasWrapmodes(header) && Imf::wrapmodes(header) == "periodic";
    if (Imf::hasFramesPerSecond(header)) {
        const Imf::Rational& rate = Imf::framesPerSecond(header);
        metadata.frame_rate = FrameRate{rate.n, static_cast<int>(rate.d)};
    }
    for (auto entry = header.begin(); entry != header.end(); ++entry) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&entry.attribute());
        if (text != nullptr && std::ranges::find(kNoTexts, entry.name()) == kNoTexts.end()) {
            metadata.text.emplace_back(entry.name(), text->value());
        }
    }
    return metadata;
}

Picture decode(std::span<const std::byte> content, int level) {
    check_exr_header(content);
    ExrInput stream(content);
    Imf::InputFile file(stream, 0);
    const bool tiled = file.header().hasTileDescription();
    if (!tiled && level != 0) {
        throw InputError(fmt::format("mip level {} does not exist", level));
    }
    return {tiled ? read_tiles(content, level) : read_rows(file), metadata_of(file.header())};
}

}  // namespace

Picture decode_exr(std::span<const std::byte> content, int level) {
    try {
        return decode(content, level);
    } catch (const InputError& error) {
        throw InputError(fmt::format("unreadable EXR: {}", error.what()));
    } catch (const OutOfMemory&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(fmt::format("malformed EXR: {}", error.what()));
    }
}

}  // namespace foam::texgen
