// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/standard_error.h"

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/manifest/manifest_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

namespace foam::texgen {
namespace {

/// Runs the program with stderr redirected as in a shell. The # hides the redirections that
/// run_program appends.
int code_with(const std::string& arguments,
              const std::string& redirection,
              const TemporaryFolder& folder) {
    return run_program(arguments + " >/dev/null " + redirection + " #", folder).code;
}

// Redirections with which stderr is full, or closed.
constexpr std::array<const char*, 2> kLostStreams = {"2>/dev/full", "2>&-"};

TEST(StandardError, ErrorsThatAreLostKeepTheirExitCodes) {
    const TemporaryFolder folder;
    for (const char* const lost : kLostStreams) {
        EXPECT_EQ(code_with("bake nope", lost, folder), 2) << lost;
        EXPECT_EQ(code_with("--frobnicate", lost, folder), 2) << lost;
        EXPECT_EQ(code_with("verify nodir", lost, folder), 4) << lost;
        EXPECT_EQ(code_with("simulate sea_foam --cache /dev/null/foam", lost, folder), 5) << lost;
    }
}

TEST(StandardError, ProgressThatIsLostDoesNotStopABake) {
    const std::string bake =
        "bake sea_foam --set foam.bubbles=16 --set frames.count=6 --frames 1-4 --size 16 "
        "--maps lit,height --out out/{map}.####.png ";
    for (const char* const lost : kLostStreams) {
        for (const char* const style : {"", "-v", "--progress json"}) {
            const TemporaryFolder folder;
            EXPECT_EQ(code_with(bake + style, lost, folder), 0) << style << lost;
            const Manifest manifest = read_manifest(folder.path() / "out");
            ASSERT_EQ(manifest.sets.size(), 1U);
            EXPECT_EQ(manifest.sets.front().failure, "");
            EXPECT_EQ(manifest.sets.front().files.size(), 8U);
            EXPECT_EQ(run_program("verify out", folder).code, 0) << style << lost;
        }
    }
}

// After the reader has closed the pipe, the first write would end the program by SIGPIPE, which a
// shell shows as the code 141.
TEST(StandardError, APipeWithoutAReaderDoesNotStopABake) {
    const TemporaryFolder folder;
    const std::string program = "'" + foam::test::executable().string() + "'";
    run_program("--version >/dev/null; { sleep 0.2; " + program +
                    " bake sea_foam --set foam.bubbles=16 --frames 1-3 --size 16 "
                    "--out a.####.png -v 2>&1 >out; echo $? >code; } | true",
                folder);
    EXPECT_EQ(file_content(folder.path() / "code"), "0\n");
    EXPECT_EQ(file_content(folder.path() / "out"), "a.####.png 1-3\n");
}

// A closed stdout is still an output that cannot be written.
TEST(StandardError, AClosedStdoutIsAnError) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_program("presets list >&- 2>/dev/null #", folder).code,
              static_cast<int>(ExitCode::OutputFailed));
}

// A reader that is slow: nothing reads the pipe until its buffer is full.
TEST(StandardError, AFullPipeDoesNotHoldUpProgress) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const int before = dup(STDERR_FILENO);
    dup2(ends[1], STDERR_FILENO);
    const std::string line(1000, 'x');
    for (int k = 0; k < 1000; ++k) {
        write_stderr_without_waiting(line);  // a write that waits would never return
    }
    dup2(before, STDERR_FILENO);
    close(before);
    close(ends[1]);
    std::string read_back(2'000'000, ' ');
    std::size_t total = 0;
    for (ssize_t got = 1; got > 0; total += static_cast<std::size_t>(std::max<ssize_t>(got, 0))) {
        got = read(ends[0], read_back.data() + total, read_back.size() - total);
    }
    close(ends[0]);
    EXPECT_GT(total, 1000U);
    EXPECT_LT(total, 1'000'000U);
    EXPECT_EQ(total % 1000, 0U);  // lines are written whole or not at all
}

}  // namespace
}  // namespace foam::texgen
