// SPDX-License-Identifier: Apache-2.0

// Prints a table of the quality and the speed of the block compression of images. The arguments are
// PNG files of 8 bits. If BC7ENC names the program bc7enc, the table also has its results.

#include "core/files/scratch_folder.h"
#include "texgen/image/external_program.h"
#include "texgen/image/format.h"
#include "texgen/image/gpu_texture.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Returns the peak signal-to-noise ratio, in decibels, of the first channels of two pictures.
// Channels that they do not have are without errors.
double psnr(const Picture& a, const Picture& b, int channels) {
    const auto& x = std::get<Image<std::uint8_t>>(a.groups.front().samples);
    const auto& y = std::get<Image<std::uint8_t>>(b.groups.front().samples);
    double sum = 0.0;
    for (int row = 0; row < x.height(); ++row) {
        for (int column = 0; column < x.width(); ++column) {
            for (int k = 0; k < std::min(channels, x.channels()); ++k) {
                const auto c = static_cast<std::size_t>(k);
                const double difference = x.pixel(column, row)[c] - y.pixel(column, row)[c];
                sum += difference * difference;
            }
        }
    }
    const double mean = sum / (static_cast<double>(x.width()) * x.height() * channels);
    return 10.0 * std::log10(255.0 * 255.0 / mean);
}

// The quality and the time of one encoder for one image.
struct Result {
    double decibels = 0.0;      // of x, or of red, green and blue
    double all_decibels = 0.0;  // of x and y, or of red, green, blue and alpha
    double seconds = 0.0;
};

Result measured(const Picture& picture, const GpuEncoding& encoding, bool normals) {
    const auto begin = std::chrono::steady_clock::now();
    const GpuTexture texture = texture_of(picture, encoding);
    const double seconds = seconds_since(begin);
    const Picture decoded = picture_of(texture);
    return {
        psnr(picture, decoded, normals ? 1 : 3), psnr(picture, decoded, normals ? 2 : 4), seconds};
}

// Runs bc7enc and reads its log. The quality is 0 if the program cannot be run.
Result bc7enc(const std::string& program,
              const std::filesystem::path& png,
              bool normals,
              const std::filesystem::path& folder) {
    std::vector<std::string> arguments = {"sh", "-c", "\"$0\" \"$@\" > log.txt 2>&1", program};
    arguments.emplace_back("-o");
    if (normals) {
        arguments.emplace_back("-5");
    }
    const std::filesystem::path copy = folder / "image.png";
    std::filesystem::copy_file(png, copy, std::filesystem::copy_options::overwrite_existing);
    arguments.push_back(copy.string());
    run_external(arguments, {.folder = folder});
    std::ifstream file(folder / "log.txt");
    const std::string log(std::istreambuf_iterator<char>(file), {});
    const auto number = [&](const std::string& pattern) {
        std::smatch match;
        return std::regex_search(log, match, std::regex(pattern)) ? std::stod(match[1]) : 0.0;
    };
    const auto quality = [&](const std::string& row) {
        return number(row + " *Max error: *[0-9]+ RMSE: [0-9.]+ PSNR ([0-9.]+)");
    };
    return {quality(normals ? "Red " : "RGB "),
            quality(normals ? "RG " : "RGBA "),
            number("Total encoding time: ([0-9.]+)")};
}

void print_row(const std::filesystem::path& png,
               const char* program,
               const ScratchFolder& scratch) {
    const Picture picture = read_picture(png);
    const bool normals = png.stem().string().find("normal") != std::string::npos;
    const GpuEncoding encoding{.mip_levels = false,
                               .meaning = normals ? TexelMeaning::Normals : TexelMeaning::Numbers};
    const Result ours = measured(picture, encoding, normals);
    const Result peer =
        program != nullptr ? bc7enc(program, png, normals, scratch.path()) : Result();
    const auto cells = [](const Result& result) {
        return fmt::format("{:.1f} dB | {:.1f} dB | {:.2f} s",
                           result.decibels,
                           result.all_decibels,
                           result.seconds);
    };
    fmt::print("| {} | {} | {} | {} |\n",
               png.stem().string(),
               normals ? "BC5, x" : "BC7",
               cells(ours),
               program != nullptr ? cells(peer) : "| |");
}

}  // namespace
}  // namespace foam::texgen

int main(int count, char** arguments) {
    const foam::ScratchFolder scratch;
    fmt::print(
        "| image | format | RGB or x | RGBA or xy | time, one thread | bc7enc | | its time, all "
        "threads |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const char* const png : std::span(arguments, static_cast<std::size_t>(count)).subspan(1)) {
        foam::texgen::print_row(png, std::getenv("BC7ENC"), scratch);
    }
    return 0;
}
