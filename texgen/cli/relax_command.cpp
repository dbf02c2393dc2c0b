// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate_given.h"
#include "core/files/file_io.h"
#include "core/io/foam_file.h"
#include "texgen/animation/seconds_since.h"
#include "texgen/bake/estimated_memory.h"
#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/options.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace foam::texgen {

namespace {

constexpr const char* kRelaxExamples = R"(Examples:
  foamtex relax torus.fe -o relaxed.fe
  foamtex relax torus.fe -o state.json --json
Files: .fe and .dmp are data files of Surface Evolver, .json is a foam state of foamtex.)";

struct RelaxArguments {
    std::string in;
    std::string out;
    int threads = 0;
    bool json = false;
    bool quiet = false;
};

struct RelaxReport {
    EquilibriumSummary summary;
    std::size_t bubbles = 0;
    double seconds = 0.0;  // wall time of the solver, without reading and writing files
};

const char* status_word(EquilibriumStatus status) {
    switch (status) {
        case EquilibriumStatus::Converged:
            return "converged";
        case EquilibriumStatus::RoundLimit:
            return "round_limit";
        default:
            return "tolerance_missed";
    }
}

std::size_t bubble_count(const Foam& foam) {
    return foam.network.bubble_count() + foam.lone_bubbles.size();
}

RelaxReport relax_loaded(Foam& foam, int threads) {
    const auto start = std::chrono::steady_clock::now();
    const EquilibriumSummary summary = equilibrate_given(foam, threads);
    return {summary, bubble_count(foam), seconds_since(start)};
}

void print_report(const RelaxReport& report) {
    print_json({{"status", status_word(report.summary.status)},
                {"bubbles", report.bubbles},
                {"energy", number_or_null(report.summary.energy)},
                {"area_error", number_or_null(report.summary.area_error)},
                {"angle_error", number_or_null(report.summary.angle_error)},
                {"iterations", report.summary.iterations},
                {"t1", report.summary.t1},
                {"t2", report.summary.t2},
                {"seconds", report.seconds}});
}

void print_line(const RelaxReport& report, const std::string& out) {
    print_stdout(
        "{}: {} bubbles, energy {:.15g}, area error {:.1e}, angle error {:.1e}, "
        "{} iterations, {} T1, {:.2f} s\n",
        out,
        report.bubbles,
        report.summary.energy,
        report.summary.area_error,
        report.summary.angle_error,
        report.summary.iterations,
        report.summary.t1,
        report.seconds);
}

void print_notes(const LoadedFoam& loaded, const std::string& in) {
    for (const std::string& note : loaded.notes) {
        print_stderr("foamtex: {}: note: {}", in, note);
    }
}

/// Prints one line that says that the foam did not reach equilibrium. The line also contains all
/// notes of load_foam about the file, because they may explain the failure.
void print_failure(const LoadedFoam& loaded, const std::string& in) {
    print_stderr("foamtex: {}: the foam did not reach equilibrium{}{}",
                 in,
                 loaded.notes.empty() ? "" : "; note: ",
                 fmt::join(loaded.notes, "; "));
}

ExitCode run_relax(const RelaxArguments& arguments) {
    check_foam_name(arguments.in);
    check_foam_name(arguments.out);
    check_writable(std::filesystem::path(arguments.out).parent_path());
    LoadedFoam loaded = load_foam(arguments.in);
    const MemoryNeed need{estimated_foam_memory(bubble_count(loaded.foam))};
    if (!arguments.quiet) {
        warn_of_little_memory(need);
    }
    const RelaxReport report =
        with_memory(need, [&] { return relax_loaded(loaded.foam, arguments.threads); });
    const bool converged = report.summary.converged();
    if (converged) {
        save_foam(arguments.out, loaded.foam);
    } else {
        print_failure(loaded, arguments.in);
    }
    if (converged && !arguments.quiet) {
        print_notes(loaded, arguments.in);
    }
    if (arguments.json) {
        print_report(report);
    } else if (converged && !arguments.quiet) {
        print_line(report, arguments.out);
    }
    return converged ? ExitCode::Success : ExitCode::NoEquilibrium;
}

}  // namespace

void add_relax_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("relax", "Compute the equilibrium of a foam in a file");
    const auto arguments = std::make_shared<RelaxArguments>();
    command->add_option("IN", arguments->in, "File of the foam: .fe, .dmp or .json")
        ->required()
        ->option_text(" ");
    command
        ->add_option(
            "-o,--out", arguments->out, "File for the foam in equilibrium: .fe, .dmp or .json")
        ->required()
        ->option_text("OUT");
    add_threads_option(*command, arguments->threads);
    add_json_option(*command, arguments->json);
    add_quiet_option(*command, arguments->quiet, "Print only errors and, with --json, the results");
    command->footer(kRelaxExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_relax(*arguments); }; });
}

}  // namespace foam::texgen
