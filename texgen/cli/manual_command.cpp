// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command.h"
#include "texgen/cli/grammar.h"
#include "texgen/cli/manual.h"
#include "texgen/cli/standard_output.h"

#include <CLI/CLI.hpp>

namespace foam::texgen {

namespace {

constexpr const char* kManualExamples = R"(Examples:
  foamtex manual | man -l -
  foamtex manual > /usr/local/share/man/man1/foamtex.1)";

}  // namespace

void add_manual_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("manual", "Print the manual page");
    command->footer(kManualExamples);
    command->callback([&action, &app] {
        action = [&app] {
            write_stdout(manual_page(grammar_of(app), FOAMTEX_VERSION, FOAMTEX_DATE));
            return ExitCode::Success;
        };
    });
}

}  // namespace foam::texgen
