#include "texgen/sheet/video.h"

#include "texgen/image/scratch_folder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

namespace foam::texgen {

namespace {

using Arguments = std::vector<std::string>;

/// Nothing comes in, and nothing goes out but errors.
class Streams {
  public:
    Streams() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    }
    ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
    Streams(const Streams&) = delete;
    Streams& operator=(const Streams&) = delete;

    const posix_spawn_file_actions_t* actions() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

[[noreturn]] void fail_to_start(int error) {
    throw OutputError(error == ENOENT ? "MP4 and GIF are made by ffmpeg, which is not installed"
                                      : fmt::format("cannot start ffmpeg: {}",
                                                    std::generic_category().message(error)));
}

/// Until it ends; its exit code, or -1 where a signal ended it.
int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            fail_to_start(errno);
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs ffmpeg without a shell, so that nothing in a name has a meaning.
void run_ffmpeg(Arguments arguments) {
    arguments.insert(arguments.begin(), {"ffmpeg", "-loglevel", "error", "-nostdin", "-y"});
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    const Streams streams;
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, "ffmpeg", streams.actions(), nullptr, pointers.data(), environ);
    if (error != 0) {
        fail_to_start(error);
    }
    if (const int code = wait_for(child); code != 0) {
        throw OutputError(fmt::format("ffmpeg failed with exit code {}", code));
    }
}

/// Colours of a PNG are sRGB: the primaries of BT.709, whose matrix is said, too.
Arguments mp4_arguments() {
    return {"-vf",
            "crop=floor(iw/2)*2:floor(ih/2)*2:0:0,scale=out_color_matrix=bt709:flags=accurate_rnd",
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
    const Arguments more = format == VideoFormat::Mp4 ? mp4_arguments() : gif_arguments();
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.push_back(to.string());
    run_ffmpeg(std::move(arguments));
    return read_file(to);
}

}  // namespace foam::texgen
