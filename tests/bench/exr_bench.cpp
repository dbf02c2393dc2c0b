// SPDX-License-Identifier: Apache-2.0

// Compares our EXR writer with OpenEXR's own compressor. The file has eight channels of a foam: its
// colors, the distance to the films and its gradient as half floats, the distance also as floats,
// and the ids of bubbles as integers.
//
//     exr_bench [SIDE [BUBBLES]]           default: 2048 pixels, 1000 bubbles

#include "tests/bench/bench_foams.h"
#include "tests/bench/encode_cost.h"
#include "tests/support/albedo_image.h"
#include "texgen/image/exr.h"
#include "texgen/image/exr_planes.h"
#include "texgen/image/exr_stream.h"
#include "texgen/raster/distance/distance.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace foam::bench {

namespace {

using texgen::ExrChannel;
using texgen::Image;
using texgen::SampleType;

// The images whose channels are encoded.
struct Images {
    Image<float> colors;    // from 0 to 1
    Image<float> distance;  // to the nearest film, in pixels
    Image<float> slopes;    // differences of the distance between successive columns and rows
    Image<std::uint32_t> ids;
};

Image<float> as_numbers(const Image<std::uint8_t>& codes) {
    Image<float> numbers(codes.width(), codes.height(), codes.channels());
    std::ranges::transform(codes.samples(), numbers.samples().begin(), [](std::uint8_t code) {
        return static_cast<float>(code) / 255.0F;
    });
    return numbers;
}

Image<float> slopes_of(const Image<float>& distance) {
    const int side = distance.width();
    Image<float> slopes(side, side, 2);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float here = distance.pixel(x, y)[0];
            slopes.pixel(x, y)[0] = distance.pixel((x + 1) % side, y)[0] - here;
            slopes.pixel(x, y)[1] = distance.pixel(x, (y + 1) % side)[0] - here;
        }
    }
    return slopes;
}

Images images_of(int bubbles, int side) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    texgen::DistanceField field = texgen::distance_field(frame, {side, side}, {}, 1);
    Image<float> slopes = slopes_of(field.distance);
    return {as_numbers(test::albedo_image(frame, {side, side}, {}, 1)),
            std::move(field.distance),
            std::move(slopes),
            std::move(field.ids)};
}

std::vector<ExrChannel> channels_of(const Images& images) {
    const auto half = [](const char* name, const Image<float>& image, int index) {
        return ExrChannel{name, SampleType::Half, image.view(), index};
    };
    return {half("R", images.colors, 0),
            half("G", images.colors, 1),
            half("B", images.colors, 2),
            half("distance.Y", images.distance, 0),
            half("slope.X", images.slopes, 0),
            half("slope.Y", images.slopes, 1),
            {"far.Z", SampleType::Float, images.distance.view(), 0},
            {"id.ID", SampleType::Uint32, images.ids.view(), 0}};
}

// Encodes channels with OpenEXR alone, to the same pixels. Returns the number of bytes.
std::size_t openexr_encode(const std::vector<ExrChannel>& channels,
                           int side,
                           int level,
                           int threads) {
    Imf::setGlobalThreadCount(threads > 1 ? threads : 0);
    Imf::Header header(side, side);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = level;
    for (const ExrChannel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(texgen::pixel_type(channel.type)));
    }
    texgen::ExrPlanes planes(channels);
    Bytes bytes;
    {
        texgen::ExrOutput stream(bytes);
        Imf::OutputFile file(stream, header, threads);
        file.setFrameBuffer(planes.buffer());
        file.writePixels(side);
    }
    return bytes.size();
}

void run(int side, int bubbles) {
    fmt::print("{} x {} pixels, {} bubbles; least of {} runs\n", side, side, bubbles, kRepeats);
    const Images images = images_of(bubbles, side);
    const std::vector<ExrChannel> channels = channels_of(images);
    const auto ours = [&](int level, int threads) {
        return min_cost([&] {
            const texgen::ExrEncoding encoding{.zip_level = level, .threads = threads};
            return texgen::encode_exr(channels, {}, encoding).size();
        });
    };
    const auto openexr = [&](int level, int threads) {
        return min_cost([&] { return openexr_encode(channels, side, level, threads); });
    };
    for (const int threads : {1, 2}) {
        print_head(threads == 1 ? "one thread" : "two threads");
        const Cost peer = openexr(Imf::Header().zipCompressionLevel(), threads);
        print_row("OpenEXR, its default", peer, peer);
        print_row("OpenEXR, level 2", openexr(2, threads), peer);
        print_row("foamtex, level 2", ours(2, threads), peer);
        print_row("foamtex, level 4", ours(4, threads), peer);
        print_row("foamtex, level 9", ours(9, threads), peer);
    }
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    return foam::bench::run_encode_bench(argc, argv, 2048, foam::bench::run);
}
