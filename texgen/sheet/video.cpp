// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/video.h"

#include "core/files/scratch_folder.h"
#include "texgen/image/external_program.h"

#include <fmt/core.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

using Arguments = std::vector<std::string>;

// Returns the last kMaxLines lines of a text file, joined into one line with a space before each of
// them.
std::string last_lines(const std::filesystem::path& path) {
    constexpr std::size_t kMaxLines = 5;
    std::deque<std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        lines.push_back(" " + line);
        if (lines.size() > kMaxLines) {
            lines.pop_front();
        }
    }
    return std::accumulate(lines.begin(), lines.end(), std::string());
}

// Runs ffmpeg. Throws OutputError if it is not installed or fails.
void run_ffmpeg(Arguments arguments) {
    const ScratchFolder folder;
    const std::filesystem::path errors = folder.path() / "errors";
    arguments.insert(arguments.begin(), {"ffmpeg", "-loglevel", "error", "-nostdin", "-y"});
    const std::optional<int> code = run_external(std::move(arguments), {.error_file = errors});
    if (!code) {
        throw OutputError(
            "cannot write MP4 or GIF: the program 'ffmpeg' was not found in PATH; install ffmpeg "
            "or use --as loop");
    }
    if (*code != 0) {
        throw OutputError(
            fmt::format("ffmpeg failed with exit code {}:{}", *code, last_lines(errors)));
    }
}

// The colors of the animated PNG that ffmpeg reads are sRGB, which has the primaries of BT.709.
// Primaries, transfer function and matrix are declared in the video. The chroma format 4:2:0
// requires an even width and height. A width or height of 1 pixel is therefore doubled; any other
// odd size is cropped by 1 pixel.
Arguments mp4_arguments() {
    const std::string crop = "crop='max(1,floor(iw/2)*2)':'max(1,floor(ih/2)*2)':0:0";
    const std::string scale =
        "scale='max(2,iw)':'max(2,ih)':out_color_matrix=bt709:flags=accurate_rnd";
    return {"-vf",
            crop + "," + scale,
            "-c:v",
            "libx264",
            "-preset",
            "slow",
            "-crf",
            "16",
            "-pix_fmt",
            "yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "iec61966-2-1",
            "-movflags",
            "+faststart",
            "-f",
            "mp4"};
}

Arguments gif_arguments() {
    return {"-vf",
            "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a",
            "-loop",
            "0",
            "-f",
            "gif"};
}

}  // namespace

void check_ffmpeg() {
    run_ffmpeg({"-version"});
}

Bytes encode_video(std::span<const std::byte> apng, FrameRate rate, VideoFormat format) {
    const ScratchFolder folder;
    const std::filesystem::path from = folder.path() / "frames.png";
    const std::filesystem::path to = folder.path() / "video";
    write_file(from, apng);
    Arguments arguments{
        "-r", fmt::format("{}/{}", rate.frames, rate.seconds), "-f", "apng", "-i", from.string()};
    const Arguments encoding = format == VideoFormat::Mp4 ? mp4_arguments() : gif_arguments();
    arguments.insert(arguments.end(), encoding.begin(), encoding.end());
    arguments.push_back(to.string());
    run_ffmpeg(std::move(arguments));
    return read_file(to, kImageInput);
}

}  // namespace foam::texgen
