// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <cstddef>

namespace foam::texgen {

/// The limits of a server.
struct HttpLimits {
    /// The largest number of open connections. If another one arrives, the connection that has
    /// waited longest for a request is closed. If all connections have a request in work, new ones
    /// wait until one of them is closed.
    std::size_t connections = 16;
    std::size_t header_bytes = 8'192;
    std::size_t body_bytes = 1'048'576;
    /// The time in which a request must arrive completely, counted from the end of the response
    /// before it, and the time in which a client must read a response.
    std::chrono::milliseconds transfer{30'000};
};

}  // namespace foam::texgen
