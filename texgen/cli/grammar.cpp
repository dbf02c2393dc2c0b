// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/grammar.h"

#include <CLI/CLI.hpp>

namespace foam::texgen {

namespace {

// Returns the placeholder of an option's value, or an empty text for a flag. If an option with a
// value has no placeholder, returns "VALUE". Flags have the option text " ", because the help would
// otherwise show a default value.
std::string value_of(const CLI::Option& option) {
    const std::string text = CLI::detail::trim_copy(option.get_option_text());
    const bool takes_one = option.get_items_expected_max() > 0;
    return takes_one && text.empty() ? "VALUE" : text;
}

ArgumentGrammar positional_of(const CLI::Option& option) {
    return {.names = {option.get_name(true)}, .value = "", .meaning = option.get_description()};
}

ArgumentGrammar option_of(const CLI::Option& option) {
    ArgumentGrammar grammar{.names = {},
                            .value = value_of(option),
                            .meaning = option.get_description(),
                            .repeats = option.get_expected_max() > 1};
    for (const std::string& name : option.get_snames()) {
        grammar.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        grammar.names.push_back("--" + name);
    }
    return grammar;
}

}  // namespace

CommandGrammar grammar_of(const CLI::App& app) {
    CommandGrammar grammar{app.get_name(), app.get_description(), {}, {}, {}, app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) {
            grammar.positionals.push_back(positional_of(*option));
        } else {
            grammar.options.push_back(option_of(*option));
        }
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        grammar.commands.push_back(grammar_of(*command));
    }
    return grammar;
}

}  // namespace foam::texgen
