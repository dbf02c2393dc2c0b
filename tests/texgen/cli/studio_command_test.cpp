// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

// This xdg-open fails, as the true one does if no browser is installed. The studio is given up to
// 10 seconds to say so.
TEST(StudioCommand, GivesAHintIfNoBrowserOpens) {
    const TemporaryFolder folder;
    const std::filesystem::path opener = folder.path() / "xdg-open";
    std::ofstream(opener) << "#!/bin/sh\nexit 3\n";
    std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
    run_program(
        "--version > /dev/null; { PATH=\".:$PATH\" '" + foam::test::executable().string() +
            "' studio > url 2> err & for k in $(seq 500); do grep -q 'by hand' err && break; "
            "sleep 0.02; done; kill -TERM $!; wait $!; }",
        folder);
    const std::string err = file_content(folder.path() / "err");
    EXPECT_NE(err.find("foamtex: the browser could not be opened; open the address by hand\n"),
              std::string::npos)
        << err;
}

// A studio that does not end is stopped after 20 seconds, which gives another code.
TEST(StudioCommand, EndsIfItsAddressCannotBeWritten) {
    const std::string studio =
        "timeout 20 '" + foam::test::executable().string() + "' studio --no-browser --json ";
    for (const char* lost : {">/dev/full", ">&-"}) {
        const TemporaryFolder folder;
        const Outcome outcome =
            run_program("--version > /dev/null; " + studio + lost + " 2>err #", folder);
        EXPECT_EQ(outcome.code, 5) << lost;
        EXPECT_EQ(file_content(folder.path() / "err"),
                  "foamtex: cannot write to standard output\n");
    }
}

}  // namespace
}  // namespace foam::texgen
