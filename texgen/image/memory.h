// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace foam::texgen {

/// Reports that the machine has too little memory. The message says how much is needed and what to
/// lower.
class OutOfMemory : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Returns the number of bytes that this process can still use without swapping: the smallest of
/// the memory that the machine has available, of the limit of the control group (cgroup version 2)
/// of the process, and of the limit of its address space (ulimit -v). Returns the largest number if
/// none is known.
std::uint64_t available_memory();

/// Throws OutOfMemory if fewer than `bytes` bytes are available. `what` begins the message, such as
/// "an image of 10 x 10 pixels".
void require_memory(std::uint64_t bytes, const std::string& what);

/// Returns a number of bytes for users, such as "1.5 GB".
std::string amount_of_bytes(std::uint64_t bytes);

}  // namespace foam::texgen
