// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/standard_output.h"
#include "texgen/material/profile.h"
#include "texgen/material/shipped_profiles.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kProfilesExamples = R"(Examples:
  foamtex profiles                           lists the shipped profiles
  foamtex bake lava --for unreal             bakes the maps that the engine needs
  foamtex profiles show unreal > my.toml     a starting point for a profile of your own
  foamtex bake lava --for my.toml)";

constexpr const char* kShowProfileExamples = R"(Examples:
  foamtex profiles show unreal > my.toml
  foamtex bake lava --for my.toml)";

ExitCode list_profiles() {
    std::size_t width = 0;
    for (const ShippedProfile& shipped : shipped_profiles()) {
        width = std::max(width, shipped.name.size());
    }
    for (const ShippedProfile& shipped : shipped_profiles()) {
        const Profile profile = load_profile(std::string(shipped.name));
        print_stdout("{:<{}}  {}\n", shipped.name, width, profile.description);
    }
    return ExitCode::Success;
}

ExitCode print_profiles_as_json() {
    Json profiles = Json::array();
    for (const ShippedProfile& shipped : shipped_profiles()) {
        const Profile profile = load_profile(std::string(shipped.name));
        profiles.push_back(
            {{"name", shipped.name}, {"description", profile.description}, {"toml", shipped.toml}});
    }
    Json report = json_report();
    report["profiles"] = profiles;
    print_json(report);
    return ExitCode::Success;
}

ExitCode show_profile(const std::string& name) {
    write_stdout(find_shipped_profile(name).toml);
    return ExitCode::Success;
}

}  // namespace

void add_profiles_command(CLI::App& app, Action& action) {
    CLI::App* profiles =
        app.add_subcommand("profiles", "List the profiles of engines for the option --for");
    profiles->require_subcommand(0, 1);
    profiles->footer(kProfilesExamples);
    const auto json = std::make_shared<bool>(false);
    profiles->add_flag("--json", *json, "Print one JSON object with all profiles")
        ->option_text(" ");
    profiles->preparse_callback([&action, json](std::size_t) {
        action = [json] { return *json ? print_profiles_as_json() : list_profiles(); };
    });
    CLI::App* show =
        profiles->add_subcommand("show", "Print a profile, as a starting point for your own");
    const auto name = std::make_shared<std::string>();
    show->add_option("PROFILE", *name, "Name of a shipped profile")->required()->option_text(" ");
    show->footer(kShowProfileExamples);
    show->callback([&action, name] { action = [name] { return show_profile(*name); }; });
}

}  // namespace foam::texgen
