#pragma once

#include <ostream>
#include <string>

namespace foam::texgen::test {

/// What a key must refuse just below and above, and accept at, its limits; as in TOML.
struct Bounds {
    std::string key;
    std::string below;
    std::string low;
    std::string high;
    std::string above;
};

/// As tests are named.
inline void PrintTo(const Bounds& bounds, std::ostream* out) {
    *out << bounds.key;
}

}  // namespace foam::texgen::test
