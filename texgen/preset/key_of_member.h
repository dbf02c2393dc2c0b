#pragma once

#include "texgen/preset/schema.h"

#include <string_view>

namespace foam::texgen {

/// object.*members[0].*members[1] and so on.
template <class Object, class... Members>
auto& at(Object& object, Members... members) {
    return (object.*....*members);
}

/// The key whose value is kept in the preset at the end of the path of members. A domain is one of
/// the kinds of value of domain.h.
template <class ValueKind, class... Members>
Key key(std::string_view path, ValueKind kind, std::string_view meaning, Members... members) {
    return {path,
            kind.allowed(),
            meaning,
            [=](const Value& value, Preset& preset) {
                return kind.read(value, at(preset, members...));
            },
            [=](const Preset& preset) { return kind.write(at(preset, members...)); }};
}

/// Makes keys of the options of one map: path, domain, meaning, member.
template <class Options>
auto keys_in(Options MapOptions::*map) {
    return [map](std::string_view path, const auto& kind, std::string_view meaning, auto member) {
        return key(path, kind, meaning, &Preset::maps, map, member);
    };
}

}  // namespace foam::texgen
