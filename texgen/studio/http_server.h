// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/studio/http_limits.h"
#include "texgen/studio/http_message.h"

#include <functional>
#include <memory>

namespace foam::texgen {

/// An HTTP/1.1 server on the loopback interface: other machines cannot reach it.
class HttpServer {
  public:
    /// Listens on 127.0.0.1 and, if the system has IPv6, on ::1. With port 0, the system chooses a
    /// free port. Throws OutputError if it cannot listen on the port.
    explicit HttpServer(int port, const HttpLimits& limits = {});
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Returns the port on which the server listens.
    int port() const;

    /// Serves requests until `on_tick` throws, and rethrows the exception. `handler` is called on a
    /// pool with at least one thread per possible connection. `on_tick` is called about ten times
    /// per second on the caller's thread. `on_end` is called before the function waits for the
    /// handlers that are still at work, so that `on_end` can end them. Precondition: `run` has not
    /// been called before.
    void run(const HttpHandler& handler,
             const std::function<void()>& on_tick,
             const std::function<void()>& on_end);

  private:
    class Listener;
    std::unique_ptr<Listener> listener_;
};

}  // namespace foam::texgen
