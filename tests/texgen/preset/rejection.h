// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <string>

namespace foam::texgen::test {

/// Returns the message of the PresetError that `read` throws, or "no failure".
template <typename Read>
std::string rejection_of(const Read& read) {
    try {
        read();
    } catch (const PresetError& error) {
        return error.what();
    }
    return "no failure";
}

}  // namespace foam::texgen::test
