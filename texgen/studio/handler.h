// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/studio/access.h"
#include "texgen/studio/bake_job.h"
#include "texgen/studio/folder.h"
#include "texgen/studio/frame_store.h"
#include "texgen/studio/http_message.h"
#include "texgen/studio/picture.h"

#include <atomic>
#include <chrono>
#include <filesystem>

namespace foam::texgen {

/// A studio: answers the requests of its pages (REQUESTS.md). Needs no socket. Thread-safe.
class Studio {
  public:
    /// `folder` is the folder below which files are read and written; `port` is the port of the
    /// server. Throws the exceptions of StudioFolder and Access.
    Studio(const std::filesystem::path& folder, int port);

    /// Answers a request. Does not throw.
    HttpResponse handle(const HttpRequest& request);

    /// Returns the token with which a page gets access (Access).
    const std::string& token() const { return access_.token(); }
    const StudioFolder& folder() const { return folder_; }

    /// Returns the time since the studio was last in use. It is in use when a page with access
    /// sends a request, and when this function is called while a bake runs. Before its first use,
    /// returns the time since the start.
    std::chrono::steady_clock::duration idle_time();

    /// Stops the bake and all simulations except drafts. Requests that wait for a simulation end
    /// with an error.
    void stop();

  private:
    HttpResponse answer(const HttpRequest& request);
    HttpResponse answer_api(const HttpRequest& request);

    Access access_;
    StudioFolder folder_;
    FrameStore store_;
    Painter painter_;
    BakeJobs bakes_;
    std::atomic<std::chrono::steady_clock::time_point> last_request_;
};

}  // namespace foam::texgen
