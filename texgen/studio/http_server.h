// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/studio/http_message.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

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

/// An HTTP/1.1 server on the loopback interface: other machines cannot reach it.
class HttpServer {
  public:
    /// Listens on 127.0.0.1 and, if the system has IPv6, on ::1. With port 0, the system chooses a
    /// free port. Throws OutputError if the port is not free.
    explicit HttpServer(int port, const HttpLimits& limits = {});
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Returns the port on which the server listens.
    int port() const;

    /// Serves requests until `on_tick` throws, and rethrows the exception. `handler` is called on
    /// as many threads as there are connections. `on_tick` is called about ten times per second on
    /// the caller's thread. `on_end` is called before the function waits for the handlers that are
    /// still at work, so that it can end them. May be called only once.
    void run(const HttpHandler& handler,
             const std::function<void()>& on_tick,
             const std::function<void()>& on_end);

  private:
    class Listener;
    std::unique_ptr<Listener> listener_;
};

}  // namespace foam::texgen
