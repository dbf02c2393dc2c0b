// SPDX-License-Identifier: Apache-2.0

// The command `completion` prints the completion script of a shell.
#include "texgen/cli/command.h"
#include "texgen/cli/completion.h"
#include "texgen/cli/grammar.h"
#include "texgen/cli/standard_output.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kCompletionExamples = R"(Examples:
  source <(foamtex completion bash)
  foamtex completion zsh > ~/.zfunc/_foamtex)";

CompletionWords completion_words() {
    CompletionWords words;
    for (const ShippedPreset& preset : shipped_presets()) {
        words.presets.emplace_back(preset.name);
    }
    for (const ShippedProfile& profile : shipped_profiles()) {
        words.profiles.emplace_back(profile.name);
    }
    words.maps.assign(map_names().begin(), map_names().end());
    for (const auto& key : preset_keys()) {
        words.keys.emplace_back(key.path);
        if (!key.words.empty()) {
            words.values_of_keys[key.path].assign(key.words.begin(), key.words.end());
        }
    }
    const std::vector<std::string_view> tables = preset_tables();
    words.tables.assign(tables.begin(), tables.end());
    return words;
}

using Script = std::string (*)(const CommandGrammar& program, const CompletionWords& words);

void add_shell(
    CLI::App& completion, const char* shell, Script script, const CLI::App& app, Action& action) {
    completion.add_subcommand(shell, fmt::format("Script for {}", shell))
        ->callback([&action, &app, script] {
            action = [&app, script] {
                write_stdout(script(grammar_of(app), completion_words()));
                return ExitCode::Success;
            };
        });
}

}  // namespace

void add_completion_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("completion", "Print a completion script for a shell");
    command->require_subcommand(1);
    command->footer(kCompletionExamples);
    add_shell(*command, "bash", bash_completion, app, action);
    add_shell(*command, "zsh", zsh_completion, app, action);
}

}  // namespace foam::texgen
