#pragma once

#include "texgen/image/image.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A channel of a picture in numbers, whatever the file stored.
struct PictureChannel {
    std::string name;
    Image<double> numbers;
};

/// A picture of any format: at least one channel, all of one size, in the order of their names.
struct Picture {
    std::vector<PictureChannel> channels;

    int width() const { return channels.front().numbers.width(); }
    int height() const { return channels.front().numbers.height(); }
};

/// The names of the channels of a PNG, a letter each: "Y", "YA", "RGB" or "RGBA".
std::string_view png_channel_names(int channels);

/// Reads a .png, of which the largest sample is 1 and nothing else is changed, with the channels
/// Y or R, G, B, and A; or an .exr as it is. Throws InputError, for a file of another name too.
Picture read_picture(const std::filesystem::path& path);

}  // namespace foam::texgen
