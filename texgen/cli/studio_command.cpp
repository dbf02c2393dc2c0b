// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/cli/command.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/external_program.h"
#include "texgen/studio/handler.h"
#include "texgen/studio/http_server.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace foam::texgen {

namespace {

constexpr const char* kStudioExamples = R"(Examples:
  foamtex studio
  foamtex studio textures --port 8080
  foamtex studio --no-browser              prints the address, to be opened by hand
The page shows the pixels that a bake writes. The printed address gives one browser access and can
be used once. To use the studio of another machine, start it there with --no-browser --port 8080,
run ssh -L 8080:localhost:8080 MACHINE here, and open the printed address. The studio ends with
Ctrl-C, or after 30 minutes without an open page or a running bake.)";

constexpr std::chrono::minutes kMaxIdleTime{30};
constexpr int kMaxPort = 65535;

struct StudioArguments {
    std::string folder;
    int port = 0;
    bool keep = false;
    bool no_browser = false;
    bool json = false;
};

/// The exception that ends the studio when no page has been open, and no bake has run, for
/// kMaxIdleTime.
class NoPages : public std::exception {};

/// Opens an address in the default browser. The program that does this may run as long as the
/// browser, so nothing waits for it.
void open_browser(const std::string& url) {
    std::thread([url] {
        const auto is_opened = [&url] {
            try {
                // The code is below 0 if a signal ended the program. In this case no message is
                // needed: the signal usually comes from Ctrl-C, which also ends the studio.
                return run_external({"xdg-open", url}, {.shows_errors = false}).value_or(1) <= 0;
            } catch (const OutputError&) {
                return false;
            }
        };
        if (!is_opened()) {
            print_stderr("foamtex: the browser could not be opened; open the address by hand");
        }
    }).detach();
}

/// Prints the address of the studio on stdout. Returns false if the address could not be written.
bool announce(const Studio& studio, const HttpServer& server, bool json) {
    const std::string url =
        fmt::format("http://localhost:{}/#token={}", server.port(), studio.token());
    if (json) {
        Json report = json_report();
        report["url"] = url;
        report["port"] = server.port();
        report["folder"] = studio.folder().path().string();
        print_json(report);
    } else {
        print_stdout("{}\n", url);
    }
    return flush_stdout();
}

ExitCode run_studio(const StudioArguments& arguments) {
    HttpServer server(arguments.port);
    Studio studio(arguments.folder, server.port());
    if (!announce(studio, server, arguments.json)) {
        return ExitCode::Success;  // run_program reports that stdout could not be written
    }
    if (!arguments.json) {
        print_stderr("foamtex: files are saved below '{}'; Ctrl-C ends the studio",
                     studio.folder().path().string());
    }
    if (!arguments.no_browser) {
        open_browser(fmt::format("http://localhost:{}/#token={}", server.port(), studio.token()));
    }
    handle_stop_signals(Stopping::Soon);
    const auto check = [&] {
        throw_if_interrupted();
        if (!arguments.keep && studio.idle_time() > kMaxIdleTime) {
            throw NoPages();
        }
    };
    try {
        server.run([&](const HttpRequest& request) { return studio.handle(request); },
                   check,
                   [&] { studio.stop(); });
    } catch (const NoPages&) {
        print_stderr("foamtex: no page was open, and no bake ran, for 30 minutes");
    } catch (const Interrupted&) {
        // This is how a user ends the studio, so it is not a failure.
    }
    return ExitCode::Success;
}

}  // namespace

void add_studio_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("studio", "Try presets and bake in a page of the browser");
    const auto arguments = std::make_shared<StudioArguments>();
    command
        ->add_option("FOLDER",
                     arguments->folder,
                     "Folder for bakes and presets (default: the working directory)")
        ->option_text(" ");
    command->add_option("--port", arguments->port, "Port of the server (default: a free one)")
        ->check(CLI::Range(0, kMaxPort))
        ->option_text("N");
    command->add_flag("--no-browser", arguments->no_browser, "Do not open the browser")
        ->option_text(" ");
    command->add_flag("--keep", arguments->keep, "Keep running when no page is open")
        ->option_text(" ");
    command->add_flag("--json", arguments->json, "Print the address as a JSON object")
        ->option_text(" ");
    command->footer(kStudioExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_studio(*arguments); }; });
}

}  // namespace foam::texgen
