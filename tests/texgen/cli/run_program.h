// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "texgen/cli/exit_code.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace foam::texgen {

/// The result of a run of the program.
struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
    std::vector<std::string> written;  // paths of all files in the working folder after the run
};

inline std::string file_content(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the shell command `foamtex ARGUMENTS` in a folder.
inline Outcome run_program(const std::string& arguments, const TemporaryFolder& work) {
    const TemporaryFolder streams;
    const std::string out = (streams.path() / "out").string();
    const std::string err = (streams.path() / "err").string();
    const std::string command = "cd " + work.path().string() + " && '" +
                                foam::test::executable().string() + "' " + arguments + " >" + out +
                                " 2>" + err;
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c)
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            file_content(out),
            file_content(err),
            work.files()};
}

/// Runs the shell command `foamtex ARGUMENTS` in a temporary folder.
inline Outcome run_program(const std::string& arguments) {
    return run_program(arguments, TemporaryFolder());
}

/// Expects that the program rejects its arguments with the exit code 2, prints "foamtex: " and
/// `line` on stderr and nothing on stdout, and writes no file.
inline void expect_rejected(const std::string& arguments, const std::string& line) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest)) << arguments;
    EXPECT_EQ(outcome.err, "foamtex: " + line + "\n");
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(outcome.written.empty()) << arguments;
}

}  // namespace foam::texgen
