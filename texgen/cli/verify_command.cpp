// SPDX-License-Identifier: Apache-2.0

#include "core/files/shown_text.h"
#include "texgen/cli/command.h"
#include "texgen/cli/image_folder.h"
#include "texgen/cli/options.h"
#include "texgen/cli/progress.h"
#include "texgen/cli/standard_output.h"
#include "texgen/verify/verify.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kVerifyExamples = R"(Examples:
  foamtex verify out
  foamtex verify out --json > report.json
Checks that every file has the pixels that the manifest records, that images of a torus tile
without a seam, and that the last frame of a loop leads into the first. Of each preset, only the
newest images are checked, unless --all is given or --size and --seed choose older ones.
Exit codes: 0 all checks passed, 6 a check failed, 4 the manifest cannot be read)";

struct VerifyArguments {
    std::string path;
    SetArguments set;
    bool all = false;
    bool json = false;
    bool quiet = false;
    std::string progress;
};

ExitCode run_verify(const VerifyArguments& arguments) {
    const Verification found = [&] {
        ProgressReporter reporter(progress_options(arguments.quiet, arguments.progress));
        return verify(read_image_manifest(arguments.path),
                      arguments.path,
                      {choice_of(arguments.set), arguments.all},
                      reporter.callback());
    }();
    if (arguments.json) {
        write_stdout(to_json(found));
    } else if (!arguments.quiet) {
        write_stdout(shown_lines(to_text(found)));
    }
    return found.holds() ? ExitCode::Success : ExitCode::CheckFailed;
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("verify", "Check baked images: pixels, tiling, the loop");
    const auto arguments = std::make_shared<VerifyArguments>();
    command->add_option("DIR", arguments->path, "Folder with a manifest.json, or the file itself")
        ->required()
        ->option_text(" ");
    add_set_options(*command, arguments->set);
    command->add_flag("--all", arguments->all, "Check older images of each preset, too")
        ->option_text(" ");
    add_json_option(*command, arguments->json);
    CLI::Option* const quiet = add_quiet_option(
        *command,
        arguments->quiet,
        "Print only errors and, with --json, the report; the exit code is the result");
    add_progress_option(*command, arguments->progress)->excludes(quiet);
    command->footer(kVerifyExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_verify(*arguments); }; });
}

}  // namespace foam::texgen
