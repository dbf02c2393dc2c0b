// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command_line_error.h"

#include "texgen/keys/nearest.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

/// Returns the program and the subcommands that the command line selects, from the outermost to the
/// innermost.
std::vector<const CLI::App*> selected_commands(const CLI::App& program) {
    std::vector<const CLI::App*> commands{&program};
    while (!commands.back()->get_subcommands().empty()) {
        commands.push_back(commands.back()->get_subcommands().front());
    }
    return commands;
}

/// Returns true if a word of the command line looks like an option. The words "-" and "--" do not.
bool looks_like_option(std::string_view word) {
    return word.starts_with('-') && word.find_first_not_of('-') != std::string_view::npos;
}

/// Returns the end of the message about an unknown word: the most similar name, or an empty text if
/// no name is similar.
std::string similar_name(std::string_view word, const std::vector<std::string>& names) {
    return did_you_mean(word, std::vector<std::string_view>(names.begin(), names.end()));
}

/// Returns the long names of the options of a command, such as "--frames". Short names are left
/// out, because every two of them are similar.
std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> subcommand_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* subcommand :
         command.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(subcommand->get_name());
    }
    return names;
}

/// Returns true if a command has an option, which is given by its long or short name.
bool has_option(const CLI::App& command, const std::string& name) {
    return command.get_option_no_throw(name) != nullptr;
}

/// Returns the message about the first unknown option of a command, or an empty text if the command
/// has none. `innermost` is the innermost subcommand of the command line.
std::string unknown_option(const CLI::App& command, const CLI::App& innermost) {
    const std::vector<std::string> words = command.remaining();
    const auto found = std::ranges::find_if(words, looks_like_option);
    if (found == words.end()) {
        return {};
    }
    const std::string option = found->substr(0, found->find('='));
    if (has_option(innermost, option)) {
        return fmt::format("the option '{}' must follow '{}'", option, innermost.get_name());
    }
    return fmt::format("{} has no option '{}'{}",
                       command.get_name(),
                       option,
                       similar_name(option, option_names(command)));
}

/// Returns the message about a word that is given instead of a subcommand, or an empty text if
/// there is no such word.
std::string unknown_subcommand(const CLI::App& command) {
    const std::vector<std::string> names = subcommand_names(command);
    const std::vector<std::string> words = command.remaining();
    if (names.empty() || words.empty()) {
        return {};
    }
    return fmt::format("{} has no command '{}'{}",
                       command.get_name(),
                       words.front(),
                       similar_name(words.front(), names));
}

std::string cause_of(const std::vector<const CLI::App*>& commands, const CLI::ParseError& error) {
    for (const CLI::App* command : commands) {
        if (std::string text = unknown_option(*command, *commands.back()); !text.empty()) {
            return text;
        }
    }
    const std::string text = unknown_subcommand(*commands.back());
    return text.empty() ? error.what() : text;
}

}  // namespace

std::string command_line_error(const CLI::App& program, const CLI::ParseError& error) {
    const std::vector<const CLI::App*> commands = selected_commands(program);
    std::vector<std::string> path;
    path.reserve(commands.size());
    for (const CLI::App* command : commands) {
        path.push_back(command->get_name());
    }
    return fmt::format("{} (see {} --help)", cause_of(commands, error), fmt::join(path, " "));
}

}  // namespace foam::texgen
