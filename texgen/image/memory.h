// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace foam::texgen {

/// Reports that too little memory is available. The message says how much is needed.
class OutOfMemory : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Returns the number of bytes that this process can still use without swapping. This is the
/// smallest of these numbers:
/// - the available memory of the machine;
/// - the unused parts of the limits of the process's control group (cgroup version 2) and of the
///   groups above it;
/// - the unused part of the limit on the process's address space (ulimit -v).
///
/// If a limit does not exist or a number is not known, the largest std::uint64_t takes its place.
std::uint64_t available_memory();

/// If the address space of this process is limited (ulimit -v), prevents the GNU C library from
/// reserving 64 MiB of it for every thread. With other C libraries, does nothing. Call this
/// function before threads are started.
void save_address_space();

/// Throws OutOfMemory if fewer than `bytes` bytes are available (available_memory). The message
/// begins with `what`, such as "an image of 10 x 10 pixels".
void require_memory(std::uint64_t bytes, const std::string& what);

/// Returns a number of bytes in MB or GB, for messages, such as "1.5 GB".
std::string amount_of_bytes(std::uint64_t bytes);

}  // namespace foam::texgen
