// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <cstddef>

namespace foam::texgen {

/// The limits of an HttpServer.
struct HttpLimits {
    /// The largest number of open connections. If another one arrives, the connection that has
    /// waited longest for a request is closed. If all connections have a request in work, each
    /// address (127.0.0.1 and ::1) accepts one more; others wait until a connection is closed.
    std::size_t connections = 16;
    std::size_t header_bytes = 8'192;
    std::size_t body_bytes = 1'048'576;
    /// The time in which a request must arrive completely, and the time in which a client must read
    /// a response. The time of a request begins with the connection or with the end of the response
    /// before it.
    std::chrono::milliseconds transfer{30'000};
};

}  // namespace foam::texgen
