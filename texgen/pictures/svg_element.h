// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string_view>

namespace foam::texgen {

/// Returns the name of an element without the prefix of its namespace.
std::string_view element_name(const pugi::xml_node& node);

/// Returns the value of a property, such as "fill", of an element. It is taken from the attribute
/// `style` (style="fill:none; opacity:0") if this contains the property, and otherwise from the
/// attribute that has the name of the property (fill="none"). Returns an empty text if there is
/// neither, or if the value is "inherit".
std::string_view element_property(const pugi::xml_node& node, std::string_view name);

/// Returns a length in pixels, or nullopt if the text is no length. Units are px, mm, cm, in, pt,
/// pc and, if `whole` is given, percent of `whole`. A number without a unit is in pixels.
std::optional<double> parse_svg_length(std::string_view text, std::optional<double> whole = {});

/// Returns the length in an attribute (parse_svg_length), or nullopt if the element has no such
/// attribute or if the attribute is "auto". Throws InputError if the attribute is no length; the
/// message does not name the file.
std::optional<double> element_length(const pugi::xml_node& node,
                                     const char* name,
                                     std::optional<double> whole = {});

}  // namespace foam::texgen
