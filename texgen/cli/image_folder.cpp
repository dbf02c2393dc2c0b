// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_folder.h"

#include "core/files/file_io.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cli/options.h"
#include "texgen/cli/standard_error.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

namespace foam::texgen {

namespace {

/// Returns the whole number that a text consists of, or nullopt if the text is not a whole number
/// that the type can hold.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && last == end && !text.empty() ? std::optional(number)
                                                                : std::nullopt;
}

void choose_size(SetChoice& choice, const std::string& size) {
    const std::size_t x = size.find('x');
    choice.width = whole_number<int>(std::string_view(size).substr(0, x));
    if (x != std::string::npos) {
        choice.height = whole_number<int>(std::string_view(size).substr(x + 1));
    }
    if (!choice.width || (x != std::string::npos && !choice.height)) {
        throw std::invalid_argument(
            fmt::format("--size {}: must be W or WxH, such as 512 or 512x256", size));
    }
}

// Returns a part of a message that suggests a subfolder with a manifest: the first in the order of
// names. Returns an empty text if no subfolder has a manifest.
std::string suggested_subfolder(const std::filesystem::path& folder) {
    std::optional<std::filesystem::path> first;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        const bool has_manifest = std::filesystem::exists(manifest_path(entry->path()), ignored);
        if (has_manifest && (!first || entry->path() < *first)) {
            first = entry->path();
        }
    }
    return first ? fmt::format("; did you mean '{}'?", first->string()) : "";
}

}  // namespace

bool is_preset_name(const std::string& path) {
    return !std::filesystem::exists(path) &&
           std::ranges::find(shipped_presets(), path, &ShippedPreset::name) !=
               shipped_presets().end();
}

void add_set_options(CLI::App& command, SetArguments& arguments) {
    add_preset_name_option(command, arguments.preset);
    command
        .add_option("--size",
                    arguments.size,
                    "Size of the images, if the folder has images of several sizes")
        ->option_text("W[xH]");
    command
        .add_option("--seed",
                    arguments.seed,
                    "Seed of the images, if the folder has images of several seeds")
        ->option_text("N");
}

SetChoice choice_of(const SetArguments& arguments) {
    SetChoice choice{.preset = arguments.preset};
    if (arguments.size) {
        choose_size(choice, *arguments.size);
    }
    if (arguments.seed) {
        choice.seed = whole_number<std::uint64_t>(*arguments.seed);
        if (!choice.seed) {
            throw std::invalid_argument(
                fmt::format("--seed {}: must be a whole number of at least 0", *arguments.seed));
        }
    }
    return choice;
}

Manifest read_image_manifest(const std::filesystem::path& path) {
    const std::string given = path.string();
    if (std::filesystem::exists(manifest_path(path))) {
        return read_manifest(path);
    }
    if (is_cache(path)) {
        throw InputError(
            fmt::format("'{0}' has simulated states, but no images; 'foamtex render "
                        "{0}' draws images of them into the folder 'out'",
                        given));
    }
    if (std::filesystem::is_directory(path)) {
        throw InputError(
            fmt::format("'{}' has no {}: foamtex has baked no images into this folder{}",
                        given,
                        kManifestName,
                        suggested_subfolder(path)));
    }
    if (is_preset_name(given)) {
        throw InputError(
            fmt::format("'{0}' is a preset, not a folder of images; 'foamtex bake "
                        "{0}' draws its images into the folder 'out'",
                        given));
    }
    return read_manifest(path);
}

const BakedSet& chosen_set(const Manifest& manifest,
                           const SetChoice& choice,
                           const std::filesystem::path& path,
                           bool quiet) {
    const BakedSet& set = newest_set(manifest, choice, path);
    const std::vector<const BakedSet*> selected = selected_sets(manifest, choice);
    if (selected.size() > 1 && !quiet) {
        std::vector<std::string> older;
        for (std::size_t k = 0; k + 1 < selected.size(); ++k) {
            older.push_back(name_of(*selected[k]));
        }
        print_stderr(
            "foamtex: note: '{}' has images of several bakes; the newest images, {}, are used; "
            "--preset, --size or --seed choose older images: {}",
            path.string(),
            name_of(set),
            fmt::join(older, ", "));
    }
    return set;
}

}  // namespace foam::texgen
