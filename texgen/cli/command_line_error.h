// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
class ParseError;
}  // namespace CLI

namespace foam::texgen {

/// Returns a message that describes an error in the command line of a program. The message ends
/// with the command that prints the help, such as "foamtex bake --help".
///
/// An unknown option or subcommand is probably the cause of the error, even if the parser reports
/// another error, such as a missing argument. The message then names the unknown word, and suggests
/// the most similar option or subcommand, if any is similar. An option of the selected subcommand
/// is also unknown if it precedes the name of the subcommand. In this case, the message says that
/// the option must follow this name.
std::string command_line_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace foam::texgen
