#pragma once

#include "texgen/animation/simulate_frames.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// --json; the flag has to outlive the parsing.
void add_json_option(CLI::App& command, bool& json);

/// The one object that a command prints on stdout with --json: `status`, and what the command adds.
class JsonReport {
  public:
    /// Of what needs no foam: `status` is complete.
    JsonReport();

    /// Of a run of frames: `status` (complete, no_equilibrium, open_loop), `failed_frame`,
    /// `closing_error`.
    explicit JsonReport(const RunOutcome& outcome);
    ~JsonReport();

    JsonReport(JsonReport&&) noexcept;
    JsonReport& operator=(JsonReport&&) noexcept;

    void add(const std::string& name, const std::string& text);
    void add(const std::string& name, int number);
    void add(const std::string& name, const std::vector<std::filesystem::path>& paths);

    void print() const;

  private:
    std::unique_ptr<nlohmann::ordered_json> object_;
};

}  // namespace foam::texgen
