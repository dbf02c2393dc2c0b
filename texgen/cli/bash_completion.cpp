// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/completion_values.h"

#include <fmt/core.h>
#include <fmt/format.h>

// In the generated script, a loop over the words of the command line finds the command path. The
// command path consists of the program, its subcommand and further subcommands, such as "foamtex
// presets show". After the loop, a first `case` completes the value of the option before the
// cursor. For each command path, it has one entry for each option with a value. A second `case`
// completes options, subcommands and positional arguments. It has one entry per command path.

namespace foam::texgen {

namespace {

std::vector<std::string> names_of(const std::vector<CommandGrammar>& commands) {
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const CommandGrammar& command : commands) {
        names.push_back(command.name);
    }
    return names;
}

constexpr const char* kBashHead =
    R"(# Completion of {0} for bash. Made by '{0} completion bash'; source it.

_{0}_words() {{
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}}

# Completes the last of several words that are separated by commas.
_{0}_list() {{
    local done=
    [[ $current == *,* ]] && done=${{current%,*}},
    mapfile -t COMPREPLY < <(compgen -P "$done" -W "$1" -- "${{current##*,}}")
    compopt -o nospace 2>/dev/null
}}

# _{0}_values KEY PREFIX WORD: completes WORD to a value of KEY, and puts PREFIX before it.
_{0}_values() {{
    local words=
    case $1 in
{4}    esac
    mapfile -t COMPREPLY < <(compgen -P "$2" -W "$words" -- "$3")
}}

_{0}_key() {{
    if [[ $current == *=* ]]; then
        _{0}_values "${{current%%=*}}" "${{current%%=*}}=" "${{current#*=}}"
        return
    fi
    mapfile -t COMPREPLY < <(compgen -S = -W "$1" -- "$current")
    compopt -o nospace 2>/dev/null
}}

_{0}_path() {{
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    compopt -o filenames 2>/dev/null
}}

_{0}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path={0} word
    COMPREPLY=()
    # Bash usually splits KEY=VALUE into three words.
    if ((COMP_CWORD > 2)) && [[ $before == '=' && ${{COMP_WORDS[COMP_CWORD - 3]}} == --@(set|sweep) ]]; then
        _{0}_values "${{COMP_WORDS[COMP_CWORD - 2]}}" '' "$current"
        return
    fi
    if ((COMP_CWORD > 2)) && [[ $current == '=' && ${{COMP_WORDS[COMP_CWORD - 2]}} == --@(set|sweep) ]]; then
        _{0}_values "$before" '' ''
        return
    fi
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case "$path $word" in
            {1}) path="$path $word" ;;
        esac
    done
    case "$path:$before" in
{2}    esac
    case "$path" in
{3}    esac
}}

complete -F _{0} {0}
)";

class BashScript {
  public:
    BashScript(const CommandGrammar& program, const CompletionWords& words)
        : program_(program.name), words_(words) {
        for (const auto& [key, values] : words.values_of_keys) {
            keys_ += fmt::format("        {}) words='{}' ;;\n", key, joined(values));
        }
        add(program, program.name);
    }

    std::string text() const {
        return fmt::format(
            kBashHead, program_, fmt::join(paths_, " | "), values_, words_of_paths_, keys_);
    }

  private:
    void add(const CommandGrammar& command, const std::string& path) {
        std::vector<std::string> options;
        for (const ArgumentGrammar& option : command.options) {
            options.insert(options.end(), option.names.begin(), option.names.end());
            if (!option.value.empty()) {
                add_option(option, path);
            }
        }
        add_words(command, path, options);
        for (const CommandGrammar& inner : command.commands) {
            paths_.push_back(fmt::format("\"{} {}\"", path, inner.name));
            add(inner, path + " " + inner.name);
        }
    }

    void add_option(const ArgumentGrammar& option, const std::string& path) {
        std::vector<std::string> patterns;
        for (const std::string& name : option.names) {
            patterns.push_back(fmt::format("\"{}:{}\"", path, name));
        }
        values_ += fmt::format("        {}) {}; return ;;\n",
                               fmt::join(patterns, " | "),
                               shell_call(values_of(option, words_)));
    }

    // Returns the call of the shell function that completes a word to one of the values.
    std::string shell_call(const Values& values) const {
        switch (values.kind) {
            case ValueKind::List:
                return fmt::format("_{}_list '{}'", program_, joined(values.words));
            case ValueKind::Key:
                return fmt::format("_{}_key '{}'", program_, joined(values.words));
            case ValueKind::Words:
                return fmt::format("_{}_words '{}'", program_, joined(values.words));
            default:
                return fmt::format("_{}_path", program_);
        }
    }

    // Adds the entry of a command to the second `case`. A word that begins with a hyphen is
    // completed to an option. Any other word is completed to a subcommand or a value of a
    // positional argument. If none of these match, the word is completed to a file, provided that a
    // positional argument of the command may be a file. Such arguments are PRESET and all arguments
    // of the kind Path.
    void add_words(const CommandGrammar& command,
                   const std::string& path,
                   const std::vector<std::string>& options) {
        std::vector<std::string> words = names_of(command.commands);
        bool takes_files = false;
        for (const ArgumentGrammar& positional : command.positionals) {
            const Values values = values_of(positional, words_);
            words.insert(words.end(), values.words.begin(), values.words.end());
            takes_files = takes_files || values.kind == ValueKind::Path ||
                          positional.names.front() == "PRESET";
        }
        words_of_paths_ += fmt::format(
            "        \"{0}\")\n"
            "            if [[ $current == -* ]]; then\n"
            "                _{1}_words '{2}'\n"
            "            else\n"
            "                _{1}_words '{3}'{4}\n"
            "            fi ;;\n",
            path,
            program_,
            joined(options),
            joined(words),
            takes_files ? "\n                ((${#COMPREPLY[@]} > 0)) || _" + program_ + "_path"
                        : "");
    }

    std::string program_;
    const CompletionWords& words_;
    std::vector<std::string> paths_;  // the command paths of all subcommands, quoted
    std::string values_;              // entries of the first `case`, for values of options
    std::string words_of_paths_;      // entries of the second `case`, for all other words
    std::string keys_;                // entries of the `case` that completes the value of a key
};

}  // namespace

std::string bash_completion(const CommandGrammar& program, const CompletionWords& words) {
    return BashScript(program, words).text();
}

}  // namespace foam::texgen
