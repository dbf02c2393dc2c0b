// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/completion_values.h"

#include "texgen/preset/output_options.h"

#include <fmt/core.h>
#include <fmt/format.h>

namespace foam::texgen {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

}  // namespace

Values values_of(const ArgumentGrammar& argument, const CompletionWords& words) {
    const std::string& name = argument.names.back();
    if (name == "--maps") {
        return {ValueKind::List, words.maps};
    }
    if (name == "--scene") {
        const auto formats = scene_formats();
        return {ValueKind::List, {formats.begin(), formats.end()}};
    }
    if (name == "--map" || name == "MAP") {
        return {ValueKind::Words, words.maps};
    }
    if (name == "--set" || name == "--sweep") {
        return {ValueKind::Key, words.keys};
    }
    if (name == "PRESET" || name == "NAME" || name == "--preset") {
        return {ValueKind::Words, words.presets};
    }
    if (name == "--for" || name == "PROFILE") {
        return {ValueKind::Words, words.profiles};
    }
    if (name == "TABLE") {
        return {ValueKind::Words, words.tables};
    }
    if (argument.value.find('|') != std::string::npos) {
        return {ValueKind::Words, split(argument.value, '|')};
    }
    return {};
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace foam::texgen
