#include "texgen/cli/command.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>

namespace foam::texgen {

namespace {

ExitCode list_presets() {
    std::size_t width = 0;
    for (const ShippedPreset& shipped : shipped_presets()) {
        width = std::max(width, shipped.name.size());
    }
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        fmt::print("{:<{}}  {}\n", shipped.name, width, preset.description);
    }
    return ExitCode::Success;
}

ExitCode show_preset(const std::string& name) {
    fmt::print("{}", find_shipped_preset(name).toml);
    return ExitCode::Success;
}

ExitCode show_keys() {
    fmt::print("{}", describe_keys());
    return ExitCode::Success;
}

}  // namespace

void add_presets_command(CLI::App& app, Action& action) {
    CLI::App* presets = app.add_subcommand("presets", "List and explain presets");
    presets->require_subcommand(0, 1);
    presets->preparse_callback([&action](std::size_t) { action = list_presets; });

    presets->add_subcommand("list", "The presets that are part of the program (the default)");
    presets->add_subcommand("keys", "Every key a preset may set: default, meaning, allowed values")
        ->callback([&action] { action = show_keys; });

    CLI::App* show = presets->add_subcommand("show", "Print a preset, to start your own from");
    const auto name = std::make_shared<std::string>();
    show->add_option("NAME", *name, "Name of a shipped preset")->required();
    show->callback([&action, name] { action = [name] { return show_preset(*name); }; });
}

}  // namespace foam::texgen
