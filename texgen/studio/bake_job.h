// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/studio/bake_plan.h"
#include "texgen/studio/folder.h"
#include "texgen/studio/frame_store.h"

#include <memory>
#include <mutex>
#include <stdexcept>

namespace foam::texgen {

/// Reports that a bake cannot start while another one runs.
class BakeIsRunning : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Runs the bakes that pages of the studio start, one at a time. Their files are written below the
/// folder of the studio. Thread-safe.
class BakeJobs {
  public:
    /// Keeps references to the folder and the store.
    BakeJobs(const StudioFolder& folder, FrameStore& store);
    ~BakeJobs();
    BakeJobs(const BakeJobs&) = delete;
    BakeJobs& operator=(const BakeJobs&) = delete;

    /// Starts a bake. Returns the answer to /api/bake (REQUESTS.md). Throws BakeIsRunning,
    /// SettingsRejected, PathRejected, and the exceptions of check_bake, check_sheets,
    /// check_sheet_folder, check_scenes and parse_frame_range.
    Json start(const BakeRequest& request);

    /// Returns the answer to /api/bake/status. Throws std::invalid_argument if `bake` is not the
    /// number of the last bake that was started.
    Json status(int bake);

    /// Stops a bake at its next progress report. Images that are complete stay. Throws as `status`
    /// does.
    void cancel(int bake);

    /// Returns true if a bake runs.
    bool is_running();

    /// Stops the running bake, if there is one, and waits until it has ended.
    void stop();

  private:
    struct Job;

    Job& job(int bake);
    void run(Job& job);

    const StudioFolder& folder_;
    FrameStore& store_;
    std::mutex mutex_;  // protects job_ and count_
    std::unique_ptr<Job> job_;
    int count_ = 0;
};

}  // namespace foam::texgen
