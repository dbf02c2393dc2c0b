// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/completion_values.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <string_view>

namespace foam::texgen {

namespace {

// Escapes a text for single quotes and for the specifications that the functions _arguments and
// _describe of zsh read. In these specifications, square brackets, colons and backslashes have a
// special meaning.
std::string zsh_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (c == '[' || c == ']' || c == ':' || c == '\\') {
            result += '\\';
        }
        result += c;
    }
    return result;
}

// Returns an action for _arguments: the last part of a specification, which offers the values. If
// the values are of the kind Words and `or_files` is true, the action also offers files.
// `key_function` is the name of the shell function that completes keys and their values.
std::string zsh_action(const Values& values, bool or_files, const std::string& key_function) {
    switch (values.kind) {
        case ValueKind::List:
            return "_sequence compadd - " + joined(values.words);
        case ValueKind::Key:
            return key_function;
        case ValueKind::Words:
            return or_files ? fmt::format("{{compadd - {}; _files}}", joined(values.words))
                            : fmt::format("({})", joined(values.words));
        default:
            return "_files";
    }
}

// Writes one shell function per command. The function calls _arguments with one specification per
// option and positional argument. If the command has subcommands, the function also completes their
// names, and calls the function of a subcommand for the words that follow its name.
class ZshScript {
  public:
    ZshScript(const CommandGrammar& program, const CompletionWords& words)
        : words_(words), key_function_("_" + program.name + "_keys") {
        text_ = fmt::format(
            "#compdef {0}\n# Completion of {0} for zsh. Made by '{0} completion zsh'; save it as "
            "_{0} in "
            "a folder of $fpath.\n",
            program.name);
        add_key_function();
        add(program, "_" + program.name);
        text_ += fmt::format("\n_{} \"$@\"\n", program.name);
    }

    const std::string& text() const { return text_; }

  private:
    void add(const CommandGrammar& command, const std::string& function) {
        for (const CommandGrammar& inner : command.commands) {
            add(inner, function + "_" + inner.name);
        }
        std::string specs;
        for (const ArgumentGrammar& option : command.options) {
            specs += option_spec(option);
        }
        for (const ArgumentGrammar& positional : command.positionals) {
            specs += positional_spec(positional);
        }
        text_ += fmt::format("\n{}() {{\n", function);
        text_ += command.commands.empty() ? fmt::format("    _arguments{}\n", specs)
                                          : dispatch(command, function, specs);
        text_ += "}\n";
    }

    // Writes the function that completes a key and, after '=', its value.
    void add_key_function() {
        std::string cases;
        for (const auto& [key, values] : words_.values_of_keys) {
            cases += fmt::format("            {}) compadd - {} ;;\n", key, joined(values));
        }
        text_ += fmt::format(
            "\n{}() {{\n    if compset -P '*='; then\n        case ${{IPREFIX%=}} in\n{}        "
            "esac\n"
            "    else\n        compadd -S = - {}\n    fi\n}}\n",
            key_function_,
            cases,
            joined(words_.keys));
    }

    std::string option_spec(const ArgumentGrammar& option) const {
        const std::string value =
            option.value.empty()
                ? ""
                : fmt::format(":{}:{}",
                              zsh_escaped(option.value),
                              zsh_action(values_of(option, words_), false, key_function_));
        const bool has_several = option.names.size() > 1;
        const std::string names = has_several
                                      ? fmt::format("'{{{}}}'", fmt::join(option.names, ","))
                                      : option.names.front();
        // Unless an option may be repeated, each of its names excludes the others.
        std::string mark = has_several ? fmt::format("({})", joined(option.names)) : "";
        mark = option.repeats ? "*" : mark;
        return fmt::format(
            " \\\n        '{}{}[{}]{}'", mark, names, zsh_escaped(option.meaning), value);
    }

    std::string positional_spec(const ArgumentGrammar& positional) const {
        const std::string& name = positional.names.front();
        return fmt::format(
            " \\\n        ':{}:{}'",
            zsh_escaped(name),
            zsh_action(values_of(positional, words_), name == "PRESET", key_function_));
    }

    static std::string dispatch(const CommandGrammar& command,
                                const std::string& function,
                                const std::string& specs) {
        std::string described;
        std::string calls;
        for (const CommandGrammar& inner : command.commands) {
            described +=
                fmt::format("            '{}:{}'\n", inner.name, zsh_escaped(inner.meaning));
            calls += fmt::format("            {0}) {1}_{0} ;;\n", inner.name, function);
        }
        return fmt::format(
            "    local state\n    local -a commands\n"
            "    _arguments -C{} \\\n        '1: :->command' \\\n        '*:: :->arguments'\n"
            "    case $state in\n        command)\n            commands=(\n{}            )\n"
            "            _describe command commands ;;\n"
            "        arguments)\n            case $words[1] in\n{}            esac ;;\n    esac\n",
            specs,
            described,
            calls);
    }

    const CompletionWords& words_;
    std::string key_function_;
    std::string text_;
};

}  // namespace

std::string zsh_completion(const CommandGrammar& program, const CompletionWords& words) {
    return ZshScript(program, words).text();
}

}  // namespace foam::texgen
