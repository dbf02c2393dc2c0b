// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_element.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/pictures/svg_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace foam::texgen {

namespace {

// Returns the value of a property as it is given, even if the value is "inherit". In the attribute
// `style`, the last value that is marked "!important" counts, or the last value if none is marked.
std::string_view given_property(const pugi::xml_node& node, std::string_view name) {
    std::string_view found = node.attribute(std::string(name).c_str()).value();
    bool is_important = false;
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
        const std::string_view declaration = style.substr(0, style.find(';'));
        style.remove_prefix(std::min(style.size(), declaration.size() + 1));
        const std::size_t colon = std::min(declaration.size(), declaration.find(':'));
        const std::size_t mark = std::min(declaration.size(), declaration.find('!'));
        const bool is_marked = mark < declaration.size();
        if (colon < mark && trimmed(declaration.substr(0, colon)) == name &&
            (is_marked || !is_important)) {
            found = trimmed(declaration.substr(colon + 1, mark - colon - 1));
            is_important = is_marked;
        }
    }
    return found;
}

// Returns the length of a unit in pixels, or nullopt if the table in this function lacks the unit.
std::optional<double> pixels_per(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"", 1.0},
                                                                            {"px", 1.0},
                                                                            {"mm", 96.0 / 25.4},
                                                                            {"cm", 96.0 / 2.54},
                                                                            {"in", 96.0},
                                                                            {"pt", 96.0 / 72.0},
                                                                            {"pc", 16.0}}};
    const auto* const found = std::ranges::find(kUnits, unit, &decltype(kUnits)::value_type::first);
    return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::string_view element_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
}

std::string_view element_property(const pugi::xml_node& node, std::string_view name) {
    const std::string_view given = given_property(node, name);
    return given == "inherit" ? std::string_view() : given;
}

std::optional<double> parse_svg_length(std::string_view text, std::optional<double> whole) {
    SvgText rest(text);
    const std::optional<double> number = rest.number();
    const bool is_percentage = whole && rest.skip('%');
    const std::optional<double> unit = is_percentage ? *whole / 100.0 : pixels_per(rest.word());
    return number && unit && rest.is_at_end() ? std::optional(*number * *unit) : std::nullopt;
}

std::optional<double> element_length(const pugi::xml_node& node,
                                     const char* name,
                                     std::optional<double> whole) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (attribute.empty() || std::string_view(attribute.value()) == "auto") {
        return std::nullopt;
    }
    const std::optional<double> length = parse_svg_length(attribute.value(), whole);
    if (!length) {
        throw InputError(fmt::format("{}=\"{}\" of a <{}> is no length in px, mm, cm, in, pt{}",
                                     name,
                                     cut_text(attribute.value()),
                                     element_name(node),
                                     whole ? ", pc or percent" : " or pc"));
    }
    return length;
}

}  // namespace foam::texgen
