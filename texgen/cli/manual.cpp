// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/manual.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace foam::texgen {

namespace {

// Escapes a text for troff. Hyphens become "\-", so that text copied from the page contains plain
// hyphens. A line that begins with a period or an apostrophe gets the prefix "\&", so that troff
// does not interpret it as a request.
std::string escaped(std::string_view text) {
    std::string result;
    bool begins_line = true;
    for (const char c : text) {
        if (begins_line && (c == '.' || c == '\'')) {
            result += "\\&";
        }
        begins_line = c == '\n';
        result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return result;
}

std::string upper(std::string text) {
    std::ranges::transform(
        text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string argument_entry(const ArgumentGrammar& argument) {
    return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n",
                       escaped(fmt::format("{}", fmt::join(argument.names, ", "))),
                       argument.value.empty() ? "" : " \\fI" + escaped(argument.value) + "\\fR",
                       escaped(argument.meaning));
}

std::string verbatim(std::string_view text) {
    return text.empty() ? "" : fmt::format(".nf\n{}\n.fi\n", escaped(text));
}

// Returns the text of a command, followed by the texts of its subcommands. `path` is the full name
// of the command, such as "foamtex presets keys".
std::string command_section(const CommandGrammar& command, const std::string& path) {
    std::string usage = path + (command.options.empty() ? "" : " [OPTIONS]");
    for (const ArgumentGrammar& positional : command.positionals) {
        usage += " " + positional.names.front();
    }
    std::string text = fmt::format(".SS {}\n{}.\n", escaped(usage), escaped(command.meaning));
    for (const auto& arguments : {command.positionals, command.options}) {
        for (const ArgumentGrammar& argument : arguments) {
            text += argument_entry(argument);
        }
    }
    text += command.notes.empty() ? "" : ".PP\n" + verbatim(command.notes);
    for (const CommandGrammar& inner : command.commands) {
        text += command_section(inner, path + " " + inner.name);
    }
    return text;
}

}  // namespace

std::string manual_page(const CommandGrammar& program,
                        std::string_view version,
                        std::string_view date) {
    std::string page = fmt::format(".TH {} 1 \"{}\" \"{} {}\" \"User Commands\"\n",
                                   upper(program.name),
                                   date,
                                   program.name,
                                   version);
    page += fmt::format(".SH NAME\n{} \\- {}\n", escaped(program.name), escaped(program.meaning));
    page += fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH OPTIONS\n",
                        program.name);
    for (const ArgumentGrammar& option : program.options) {
        page += argument_entry(option);
    }
    page += ".SH COMMANDS\n";
    for (const CommandGrammar& command : program.commands) {
        page += command_section(command, program.name + " " + command.name);
    }
    return page + ".SH NOTES\n" + verbatim(program.notes);
}

}  // namespace foam::texgen
