#include "texgen/image/picture.h"

#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

namespace foam::texgen {

namespace {

constexpr double kLargestSample = 65535.0;

template <class Sample>
Image<double> numbers_of(ImageView<const Sample> view, int channel, double scale) {
    Image<double> numbers(view.width(), view.height(), 1);
    for (int y = 0; y < view.height(); ++y) {
        for (int x = 0; x < view.width(); ++x) {
            const Sample sample = view.pixel(x, y)[static_cast<std::size_t>(channel)];
            numbers.pixel(x, y)[0] = static_cast<double>(sample) / scale;
        }
    }
    return numbers;
}

Picture picture_of(const PngImage16& image) {
    Picture picture;
    const std::string_view names = png_channel_names(image.pixels.channels());
    for (int k = 0; k < image.pixels.channels(); ++k) {
        picture.channels.push_back({std::string(1, names[static_cast<std::size_t>(k)]),
                                    numbers_of(image.pixels.view(), k, kLargestSample)});
    }
    std::ranges::sort(picture.channels, {}, &PictureChannel::name);
    return picture;
}

Picture picture_of(const ExrImage& image) {
    Picture picture;
    for (const ExrPlane& plane : image.channels) {
        picture.channels.push_back(
            {plane.name,
             std::visit([](const auto& pixels) { return numbers_of(pixels.view(), 0, 1.0); },
                        plane.pixels)});
    }
    return picture;
}

}  // namespace

std::string_view png_channel_names(int channels) {
    constexpr std::array<std::string_view, 4> kNames = {"Y", "YA", "RGB", "RGBA"};
    return kNames.at(static_cast<std::size_t>(channels - 1));
}

Picture read_picture(const std::filesystem::path& path) {
    if (path.extension() == ".png") {
        return picture_of(read_png16(path));
    }
    if (path.extension() == ".exr") {
        return picture_of(read_exr(path));
    }
    throw InputError(
        fmt::format("cannot read '{}': its name must end in .png or .exr", path.string()));
}

}  // namespace foam::texgen
