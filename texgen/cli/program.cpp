// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/program.h"

#include "core/parallel/simd_level.h"
#include "texgen/cli/command.h"
#include "texgen/cli/command_line_error.h"
#include "texgen/cli/failure.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/cli/version_text.h"
#include "texgen/image/memory.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kFooter = R"(Examples:
  foamtex studio                               try presets in the browser
  foamtex bake sea_foam                        48 frames of a tileable texture, in out/
  foamtex presets show sea_foam > my.toml      a starting point for a preset of your own

Exit codes: 0 success, 1 internal failure or out of memory, 2 bad command line or preset,
  3 the foam did not reach equilibrium, or its loop does not close, 4 bad input file,
  5 an output could not be written, 6 a check of verify failed, 129 the terminal was closed,
  130 interrupted, 143 terminated. The codes of compare are different: see foamtex compare --help)";

/// Returns the exit code of a command for a failure. `code` is the code that all commands except
/// `compare` return; `compare` uses the codes 1 and 2 for verdicts. `command` is empty if the
/// command is not known.
ExitCode code_for_command(ExitCode code, std::string_view command) {
    if (command == "compare" && code == ExitCode::BadRequest) {
        return ExitCode::CompareBadRequest;
    }
    if (command == "compare" && code == ExitCode::InternalFailure) {
        return ExitCode::CompareInternalFailure;
    }
    return code;
}

/// Reports an exception of the parser and returns the exit code. CLI11 also throws an exception for
/// --help and --version; the code of this exception is 0.
ExitCode report_parse(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        app.exit(error);
        return ExitCode::Success;
    }
    return report_failure(command_line_error(app, error), ExitCode::BadRequest);
}

/// Flushes stdout. Returns the given exit code, or OutputFailed if output was lost.
ExitCode flushed(ExitCode code) {
    return flush_stdout()
               ? code
               : report_failure("cannot write to standard output", ExitCode::OutputFailed);
}

/// Returns the name of the command that a command line selects; empty if it selects none.
std::string command_of(const CLI::App& app) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return commands.empty() ? "" : commands.front()->get_name();
}

/// Runs the program. Stores the name of the command in `command` once it is known.
ExitCode parse_and_run(int argc, char** argv, std::string& command) {
    CLI::App app("Animated, tileable foam textures from real foam physics", "foamtex");
    Action action;
    const CLI::Option* const verbose = app.add_flag("--verbose")->group("");
    app.set_version_flag(
        "--version",
        [verbose] { return version_text(verbose->count() > 0); },
        "Print the version; with --verbose, also facts about the build");
    app.require_subcommand(1);
    app.footer(kFooter);
    for (const AddCommand add : all_commands()) {
        add(app, action);
    }
    if (argc < 2) {
        return report_failure(
            "a command is needed: 'foamtex studio' shows presets in the browser, 'foamtex bake "
            "sea_foam' bakes one (see foamtex --help)",
            ExitCode::BadRequest);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return code_for_command(report_parse(app, error), command_of(app));
    }
    command = command_of(app);
    simd_level();  // throws here, before any work, if FOAMTEX_SIMD has an invalid value
    return action();
}

}  // namespace

ExitCode run_program(int argc, char** argv) {
    open_missing_streams();
    save_address_space();
    return run_command_line(argc, argv);
}

ExitCode run_command_line(int argc, char** argv) {
    std::string command;
    try {
        return flushed(parse_and_run(argc, argv, command));
    } catch (const std::exception&) {
        return code_for_command(report_exception(), command);
    }
}

}  // namespace foam::texgen
