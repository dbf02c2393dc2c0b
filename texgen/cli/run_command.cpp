// SPDX-License-Identifier: Apache-2.0

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/animation/seconds_since.h"
#include "texgen/cli/command.h"
#include "texgen/cli/job_file.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/cli/program.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kRunExamples = R"(Examples:
  foamtex run jobs.toml
  foamtex run jobs.toml --job 3                        the third job alone
  sbatch --array=1-12 --wrap 'foamtex run jobs.toml --job $SLURM_ARRAY_TASK_ID'
A job file has a table for each bake; its keys are the options of foamtex bake:
  [[bake]]
  preset = "lava"
  size = 2048
  set = ["foam.bubbles=200", "albedo.film_width=0.2"]
  out = "lava/{map}.####.png"
A job that fails does not stop the others. Frames that exist are kept (--resume). The exit code is
the largest exit code of the jobs.)";

struct RunCommandArguments {
    std::string file;
    std::optional<std::size_t> job;
    bool quiet = false;
    bool json = false;
};

/// The result of a job.
struct FinishedJob {
    std::size_t number = 0;  // number of the job, from 1
    ExitCode code = ExitCode::Success;
    double seconds = 0.0;
};

bool is_interrupted(ExitCode code) {
    return code >= ExitCode::HungUp;
}

FinishedJob run(const Job& job, std::size_t number, bool quiet) {
    std::vector<std::string> words = job.arguments;
    words.insert(words.begin(), "foamtex");
    words.emplace_back("--resume");
    if (quiet) {
        words.emplace_back("--quiet");
    }
    std::vector<char*> arguments(words.size());
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
    const auto begin = std::chrono::steady_clock::now();
    const ExitCode code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
    return {number, code, seconds_since(begin)};
}

void print_summary(const std::vector<FinishedJob>& finished,
                   const std::vector<Job>& jobs,
                   const RunCommandArguments& arguments) {
    const auto failed = std::ranges::count_if(
        finished, [](const FinishedJob& job) { return job.code != ExitCode::Success; });
    if (arguments.json) {
        Json report = json_report(failed == 0);
        report["failed"] = failed;
        report["jobs"] = Json::array();
        for (const FinishedJob& job : finished) {
            report["jobs"].push_back({{"job", job.number},
                                      {"command", jobs[job.number - 1].command()},
                                      {"code", static_cast<int>(job.code)},
                                      {"seconds", job.seconds}});
        }
        print_json(report);
        return;
    }
    for (const FinishedJob& job : finished) {
        if (job.code != ExitCode::Success) {
            print_stderr("foamtex: job {} ended with exit code {}: {}",
                         job.number,
                         static_cast<int>(job.code),
                         jobs[job.number - 1].command());
        }
    }
    if (!arguments.quiet) {
        print_stdout("{} of {} jobs complete\n",
                     finished.size() - static_cast<std::size_t>(failed),
                     arguments.job ? 1 : jobs.size());
    }
}

ExitCode run_jobs(const RunCommandArguments& arguments) {
    const Bytes content = read_file(arguments.file, kJobsInput);
    const std::vector<Job> jobs = read_jobs(as_text(content), arguments.file);
    if (arguments.job && *arguments.job > jobs.size()) {
        throw std::invalid_argument(
            fmt::format("--job {}: '{}' has {} jobs", *arguments.job, arguments.file, jobs.size()));
    }
    const std::size_t first = arguments.job.value_or(1);
    const std::size_t last = arguments.job.value_or(jobs.size());
    std::vector<FinishedJob> finished;
    for (std::size_t number = first; number <= last; ++number) {
        const Job& job = jobs[number - 1];
        if (!arguments.quiet && !arguments.json) {
            print_stderr("foamtex: job {} of {}: {}", number, jobs.size(), job.command());
        }
        finished.push_back(run(job, number, arguments.quiet || arguments.json));
        if (is_interrupted(finished.back().code)) {
            break;
        }
    }
    print_summary(finished, jobs, arguments);
    return std::ranges::max(finished, {}, &FinishedJob::code).code;
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("run", "Run the bakes of a job file");
    const auto arguments = std::make_shared<RunCommandArguments>();
    command->add_option("JOBS", arguments->file, "Job file, in TOML")->required()->option_text(" ");
    command->add_option("--job,--array-index", arguments->job, "Run only this job, counted from 1")
        ->check(CLI::PositiveNumber)
        ->option_text("N");
    add_quiet_option(*command, arguments->quiet);
    add_json_option(*command, arguments->json);
    command->footer(kRunExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_jobs(*arguments); }; });
}

}  // namespace foam::texgen
