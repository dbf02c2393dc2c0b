#pragma once

#include "texgen/preset/assignment.h"

#include <string>

namespace foam::texgen::test {

/// What `read` is refused with, in the user's words; "no failure" if it is not.
template <typename Read>
std::string refused(const Read& read) {
    try {
        read();
    } catch (const PresetError& error) {
        return error.what();
    }
    return "no failure";
}

}  // namespace foam::texgen::test
