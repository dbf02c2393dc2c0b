#pragma once

#include "texgen/cli/exit_code.h"

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// What the command line asked for, ready to run. Failures leave as exceptions.
using Action = std::function<ExitCode()>;

/// Each adds one command to the program; parsing a command line that names it sets `action`.
void add_bake_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_completion_command(CLI::App& app, Action& action);
void add_flipbook_command(CLI::App& app, Action& action);
void add_manual_command(CLI::App& app, Action& action);
void add_maps_command(CLI::App& app, Action& action);
void add_presets_command(CLI::App& app, Action& action);
void add_preview_command(CLI::App& app, Action& action);
void add_relax_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_simulate_command(CLI::App& app, Action& action);
void add_stats_command(CLI::App& app, Action& action);
void add_verify_command(CLI::App& app, Action& action);

}  // namespace foam::texgen
