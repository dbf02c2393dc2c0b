// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/standard_output.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kPresetsExamples = R"(Examples:
  foamtex presets                           lists the shipped presets
  foamtex presets show sea_foam > my.toml   a starting point for a preset of your own
  foamtex presets keys foam                 explains the keys of the table [foam])";

constexpr const char* kKeysExamples = R"(Examples:
  foamtex presets keys                      explains all keys, table by table
  foamtex presets keys event                explains the keys of events
  foamtex presets keys --json-schema > foamtex.schema.json
A key is set in the file of a preset, or by an option such as --set foam.bubbles=300.)";

constexpr const char* kShowExamples = R"(Examples:
  foamtex presets show sea_foam > my.toml
  foamtex bake my.toml)";

ExitCode list_presets() {
    std::size_t width = 0;
    for (const ShippedPreset& shipped : shipped_presets()) {
        width = std::max(width, shipped.name.size());
    }
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        print_stdout("{:<{}}  {}\n", shipped.name, width, preset.description);
    }
    return ExitCode::Success;
}

ExitCode print_presets_as_json() {
    Json presets = Json::array();
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        presets.push_back({{"name", shipped.name},
                           {"description", preset.description},
                           {"size", {preset.image.width, preset.image.height}},
                           {"frames", preset.frames.count},
                           {"maps", preset.image.maps},
                           {"toml", shipped.toml}});
    }
    Json report = json_report();
    report["presets"] = presets;
    print_json(report);
    return ExitCode::Success;
}

ExitCode show_preset(const std::string& name) {
    if (is_preset_path(name)) {
        throw PresetError(fmt::format(
            "'{}': must be the name of a shipped preset; 'foamtex presets' lists all of them",
            name));
    }
    write_stdout(find_shipped_preset(name).toml);
    return ExitCode::Success;
}

ExitCode show_keys(const std::string& table) {
    write_stdout(table.empty() ? describe_keys() : describe_table(table));
    return ExitCode::Success;
}

ExitCode print_schema() {
    write_stdout(preset_schema());
    return ExitCode::Success;
}

void add_list(CLI::App& presets, Action& action) {
    const auto json = std::make_shared<bool>(false);
    presets.add_flag("--json", *json, "Print one JSON object with all presets")->option_text(" ");
    presets.preparse_callback([&action, json](std::size_t) {
        action = [json] { return *json ? print_presets_as_json() : list_presets(); };
    });
    presets.add_subcommand("list", "List the shipped presets (the default)")
        ->fallthrough()
        ->footer("");
}

void add_keys(CLI::App& presets, Action& action) {
    CLI::App* keys = presets.add_subcommand(
        "keys", "List the keys of presets: default, meaning, allowed values");
    const auto table = std::make_shared<std::string>();
    const auto schema = std::make_shared<bool>(false);
    CLI::Option* name =
        keys->add_option(
                "TABLE", *table, "List only the keys of this table, such as foam, loop or event")
            ->option_text(" ");
    keys->add_flag("--json-schema",
                   *schema,
                   "Instead of the list, print a JSON Schema, with which editors complete keys")
        ->option_text(" ")
        ->excludes(name);
    keys->footer(kKeysExamples);
    keys->callback([&action, table, schema] {
        action = [table, schema] { return *schema ? print_schema() : show_keys(*table); };
    });
}

}  // namespace

void add_presets_command(CLI::App& app, Action& action) {
    CLI::App* presets = app.add_subcommand("presets", "List and explain presets");
    presets->require_subcommand(0, 1);
    presets->footer(kPresetsExamples);
    add_list(*presets, action);
    add_keys(*presets, action);

    CLI::App* show =
        presets->add_subcommand("show", "Print a preset, as a starting point for your own");
    const auto name = std::make_shared<std::string>();
    show->add_option("NAME", *name, "Name of a shipped preset")->required()->option_text(" ");
    show->footer(kShowExamples);
    show->callback([&action, name] { action = [name] { return show_preset(*name); }; });
}

}  // namespace foam::texgen
