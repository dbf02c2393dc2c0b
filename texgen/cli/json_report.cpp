#include "texgen/cli/json_report.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace foam::texgen {

namespace {

using Json = nlohmann::ordered_json;

const char* word_of(RunStatus status) {
    switch (status) {
        case RunStatus::NoEquilibrium:
            return "no_equilibrium";
        case RunStatus::OpenLoop:
            return "open_loop";
        case RunStatus::Complete:
            break;
    }
    return "complete";
}

/// JSON has no word for a number that is not finite.
Json number_or_null(const std::optional<double>& number) {
    return number && std::isfinite(*number) ? Json(*number) : Json(nullptr);
}

}  // namespace

void add_json_option(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Print one JSON object of the results")->option_text(" ");
}

JsonReport::JsonReport() : object_(std::make_unique<Json>(Json{{"status", "complete"}})) {}

JsonReport::JsonReport(const RunOutcome& outcome)
    : object_(std::make_unique<Json>(
          Json{{"status", word_of(outcome.status)},
               {"failed_frame",
                outcome.status == RunStatus::Complete ? Json(nullptr) : Json(outcome.failed_frame)},
               {"closing_error", number_or_null(outcome.closing_error)}})) {}

JsonReport::~JsonReport() = default;
JsonReport::JsonReport(JsonReport&&) noexcept = default;
JsonReport& JsonReport::operator=(JsonReport&&) noexcept = default;

void JsonReport::add(const std::string& name, const std::string& text) {
    (*object_)[name] = text;
}

void JsonReport::add(const std::string& name, int number) {
    (*object_)[name] = number;
}

void JsonReport::add(const std::string& name, const std::vector<std::filesystem::path>& paths) {
    Json list = Json::array();
    for (const std::filesystem::path& path : paths) {
        list.push_back(path.string());
    }
    (*object_)[name] = std::move(list);
}

void JsonReport::print() const {
    fmt::print("{}\n", object_->dump());
}

}  // namespace foam::texgen
