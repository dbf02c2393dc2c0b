// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

namespace foam::fuzz {

/// A function that gives input to one reader of the program. It returns normally if the reader
/// accepts the input, or rejects it with an exception that the reader's header documents. Any other
/// exception, a failed requirement (`require`), a crash and an error that a sanitizer finds are
/// faults.
struct FuzzTarget {
    std::string_view name;
    void (*run)(std::string_view input);
};

/// Returns all targets, in the order of tests/fuzz/CMakeLists.txt.
std::span<const FuzzTarget> all_targets();

/// Returns the target with the given name. If there is none, prints the names of all targets and
/// ends the program with the exit code 2.
const FuzzTarget& target_named(std::string_view name);

/// Does nothing if `holds` is true. Otherwise prints the requirement and aborts, in release builds,
/// too.
void require(bool holds, std::string_view requirement);

/// Returns read(), or nullopt if it throws an exception of one of the given types. Other exceptions
/// pass through. An exception of one of the given types must have a message (require).
template <class Rejection, class... Others, class Read>
std::optional<std::invoke_result_t<Read>> unless_rejected(const Read& read) {
    try {
        if constexpr (sizeof...(Others) == 0) {
            return read();
        } else {
            return unless_rejected<Others...>(read);
        }
    } catch (const Rejection& error) {
        require(*error.what() != '\0', "an error has a message");
        return std::nullopt;
    }
}

/// Returns the bytes of the input.
inline std::span<const std::byte> bytes_of(std::string_view input) {
    return std::as_bytes(std::span(input));
}

}  // namespace foam::fuzz
