// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/job_file.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/preset/assignment.h"

namespace foam::fuzz {

void fuzz_job_file(std::string_view input) {
    const auto jobs =
        unless_rejected<texgen::PresetError>([&] { return texgen::read_jobs(input, "jobs.toml"); });
    if (!jobs) {
        return;
    }
    require(!jobs->empty(), "a job file has a job");
    for (const texgen::Job& job : *jobs) {
        require(job.arguments.size() >= 2 && !job.arguments[1].empty(), "a job has a preset");
        require(job.command().starts_with("foamtex bake "), "a job is a command");
    }
}

}  // namespace foam::fuzz
