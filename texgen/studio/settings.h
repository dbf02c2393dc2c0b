// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"
#include "texgen/studio/folder.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {

/// The largest number of bubbles that the studio simulates while a page is open.
inline constexpr int kMaxLiveBubbles = 20'000;

/// The settings of a page: a preset, and the changes that the page makes to it.
struct PageSettings {
    // The name of a shipped preset, or the path of a preset file, relative to the studio's folder.
    std::string preset;
    std::vector<std::string> set = {};  // the arguments KEY=VALUE of options --set
    // A TOML text with tables [[event]] that replace all events of the preset.
    std::optional<std::string> events = {};
};

/// Reports settings that are not allowed. The message is one line, as the program prints it.
class SettingsRejected : public std::runtime_error {
  public:
    SettingsRejected(const std::string& message, std::string key)
        : runtime_error(message), key_(std::move(key)) {}

    /// Returns the path of the key whose value is not allowed; empty if it is not known.
    const std::string& key() const { return key_; }

  private:
    std::string key_;
};

/// Reads the member "settings" of a request. Throws InputError if it is malformed.
PageSettings read_settings(const JsonValue& request);

/// A preset with the settings of a page.
struct PagePreset {
    // The preset without the changes of the page, and without its events if the page replaces them.
    Preset base;
    std::vector<Assignment> resolved_assignments;  // the changes, with absolute paths of files
    Preset preset;                                 // `base` with the changes
    // The changes as the page gives them: paths of files are relative to the folder of the studio.
    std::vector<Assignment> assignments;
};

/// Loads the preset of a page and applies the changes of the page to it. Throws SettingsRejected if
/// a value is not allowed or the preset does not exist. Throws PathRejected if a path is not
/// allowed (StudioFolder::below).
PagePreset load_settings(const PageSettings& settings, const StudioFolder& folder);

/// Returns the preset of load_settings. Throws as load_settings does, and SettingsRejected if the
/// foam is too large to be simulated while a page is open (kMaxLiveBubbles).
Preset load_live_preset(const PageSettings& settings, const StudioFolder& folder);

/// Returns the command that bakes the images of a page. `options` are options of the command, such
/// as {"--frames", "1"}. Returns nullopt if the command line cannot express the settings, because
/// the page has changed the events.
std::optional<std::string> bake_command(const PageSettings& settings,
                                        const std::vector<std::string>& options = {});

/// Returns a preset file with the settings of a page. It extends a shipped preset if possible;
/// otherwise it contains all keys.
std::string preset_file(const PageSettings& settings, const PagePreset& loaded);

/// Returns the answer to a request to /api/settings (REQUESTS.md).
Json describe_settings(const PageSettings& settings, const StudioFolder& folder);

}  // namespace foam::texgen
