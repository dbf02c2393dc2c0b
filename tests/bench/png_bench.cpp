// SPDX-License-Identifier: Apache-2.0

// Compares our PNG writer with libpng, on one thread except in rows that name two threads. The
// images are maps of a foam: albedo, distance to the films (16 bits) and normals.
//
//     png_bench [SIDE [BUBBLES]]           default: 1024 pixels, 1000 bubbles
#include "tests/bench/bench_foams.h"
#include "tests/bench/encode_cost.h"
#include "tests/support/albedo_image.h"
#include "texgen/image/png.h"
#include "texgen/raster/distance/distance.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace foam::bench {

namespace {

using texgen::Compression;
using texgen::Image;
using texgen::ImageView;
using texgen::PngFilter;

constexpr double kSlope = 2.0;  // slope of the normal map at the largest slope in row 0

/// Returns the distance to the nearest film. The largest distance is mapped to 65535.
Image<std::uint16_t> distance_map(const Frame& frame, int side) {
    const Image<float> distance = texgen::distance_field(frame, {side, side}, {}, 1).distance;
    const float largest = std::ranges::max(distance.samples());
    Image<std::uint16_t> image(side, side, 1);
    std::ranges::transform(distance.samples(), image.samples().begin(), [&](float one) {
        return static_cast<std::uint16_t>(65535.0F * (one / largest));
    });
    return image;
}

/// Returns the normals of a periodic height map, as 8-bit RGB.
Image<std::uint8_t> normal_map(const Image<std::uint16_t>& height) {
    const int side = height.width();
    const auto at = [&](int x, int y) {
        return static_cast<double>(height.pixel((x + side) % side, (y + side) % side)[0]);
    };
    double steepest = 1.0;
    for (int x = 0; x < side; ++x) {
        steepest = std::max(steepest, std::abs(at(x + 1, 0) - at(x - 1, 0)));
    }
    const auto coded = [](double x) { return static_cast<std::uint8_t>(127.5 + 127.5 * x); };
    Image<std::uint8_t> image(side, side, 3);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double u = kSlope * (at(x - 1, y) - at(x + 1, y)) / steepest;
            const double v = kSlope * (at(x, y - 1) - at(x, y + 1)) / steepest;
            const double length = std::sqrt(u * u + v * v + 1.0);
            const auto pixel = image.pixel(x, y);
            pixel[0] = coded(u / length);
            pixel[1] = coded(v / length);
            pixel[2] = coded(1.0 / length);
        }
    }
    return image;
}

void append(png_structp png, png_bytep data, std::size_t count) {
    auto& stream = *static_cast<std::vector<png_byte>*>(png_get_io_ptr(png));
    stream.insert(stream.end(), data, data + count);
}

/// Encodes an image with libpng into memory, as our writer does. Returns the number of bytes.
/// `stream` is a buffer whose memory is reused between calls.
template <class Sample>
std::size_t libpng_encode(ImageView<const Sample> image,
                          PngFilter filter,
                          int level,
                          std::vector<png_byte>& stream) {
    constexpr std::array<int, 3> kFilters = {PNG_FILTER_NONE, PNG_FILTER_SUB, PNG_FILTER_UP};
    stream.clear();
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &stream, append, nullptr);
    png_set_IHDR(png,
                 info,
                 static_cast<png_uint_32>(image.width()),
                 static_cast<png_uint_32>(image.height()),
                 8 * static_cast<int>(sizeof(Sample)),
                 image.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, kFilters.at(static_cast<std::size_t>(filter)));
    png_set_compression_level(png, level);
    png_write_info(png, info);
    if (sizeof(Sample) == 2 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    for (int y = image.height() - 1; y >= 0; --y) {
        png_write_row(png, reinterpret_cast<png_const_bytep>(image.row(y).data()));
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return stream.size();
}

template <class Sample>
void print_map(const std::string& name, const Image<Sample>& image, PngFilter filter) {
    print_head(name);
    std::vector<png_byte> stream;
    const auto libpng = [&](int level) {
        return min_cost([&] { return libpng_encode(image.view(), filter, level, stream); });
    };
    const auto ours = [&](Compression compression, int threads) {
        return min_cost([&] {
            const texgen::PngEncoding encoding{
                .filter = filter, .compression = compression, .threads = threads};
            return texgen::encode_png(image.view(), {}, encoding).size();
        });
    };
    const Cost peer = libpng(1);
    print_row("libpng, level 1", peer, peer);
    print_row("fast", ours(Compression::Fast, 1), peer);
    print_row("fast, two threads", ours(Compression::Fast, 2), peer);
    print_row("small", ours(Compression::Small, 1), peer);
    print_row("libpng, level 6", libpng(6), peer);
    print_row("libpng, level 9", libpng(9), peer);
}

void run(int side, int bubbles) {
    const Frame frame = snapshot(equilibrated_foam(bubbles), 1);
    const Image<std::uint16_t> distance = distance_map(frame, side);
    fmt::print("{} x {} pixels, {} bubbles; least of {} runs\n", side, side, bubbles, kRepeats);
    print_map("albedo", test::albedo_image(frame, {side, side}, {}, 1), PngFilter::None);
    print_map("distance, 16 bits", distance, PngFilter::Up);
    print_map("normal", normal_map(distance), PngFilter::Up);
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    return foam::bench::run_encode_bench(argc, argv, 1024, foam::bench::run);
}
