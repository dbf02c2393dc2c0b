// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/identifier.h"

#include <algorithm>

namespace foam::texgen {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_allowed(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

}  // namespace

std::string identifier(std::string_view name) {
    std::string text = name.empty() || is_digit(name.front()) ? "_" : "";
    text += name;
    std::ranges::replace_if(
        text, [](char c) { return !is_allowed(c); }, '_');
    return text;
}

std::string Identifiers::unique(std::string_view name) {
    const std::string base = identifier(name);
    std::string text = base;
    for (int k = 2; !used_.insert(text).second; ++k) {
        text = base + "_" + std::to_string(k);
    }
    return text;
}

}  // namespace foam::texgen
