// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/json_report.h"

#include "texgen/cli/standard_output.h"

namespace foam::texgen {

namespace {

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

}  // namespace

Json json_report(bool is_complete) {
    return {{"status", is_complete ? "complete" : "failed"}};
}

Json json_report(const RunOutcome& outcome) {
    const bool complete = outcome.status == RunStatus::Complete;
    return {{"status", word_of(outcome.status)},
            {"failed_frame", complete ? Json(nullptr) : Json(outcome.failed_frame)},
            {"closing_error", number_or_null(outcome.closing_error)},
            {"relaxations", outcome.relaxations ? Json(*outcome.relaxations) : Json(nullptr)}};
}

void print_json(const Json& object) {
    write_stdout(json_text(object) + "\n");
}

}  // namespace foam::texgen
