// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/failure.h"

#include "core/files/file_io.h"
#include "core/io/format_error.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/standard_error.h"
#include "texgen/image/memory.h"
#include "texgen/preset/assignment.h"

#include <fmt/core.h>

#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// Returns the exit code of a run that a signal has stopped: 128 plus the number of the signal. A
/// shell reports the same code for a process that a signal has ended.
ExitCode code_of(const Interrupted& error) {
    constexpr int kSignals = 128;
    return static_cast<ExitCode>(kSignals + error.signal());
}

}  // namespace

ExitCode report_failure(const std::string& message, ExitCode code) {
    print_stderr("foamtex: {}", message);
    return code;
}

ExitCode report_exception() {
    try {
        throw;
    } catch (const Interrupted& error) {
        return report_failure(error.what(), code_of(error));
    } catch (const PresetError& error) {
        return report_failure(error.what(), ExitCode::BadRequest);
    } catch (const std::invalid_argument& error) {
        return report_failure(error.what(), ExitCode::BadRequest);
    } catch (const FormatError& error) {
        return report_failure(error.what(), ExitCode::BadInput);
    } catch (const InputError& error) {
        return report_failure(error.what(), ExitCode::BadInput);
    } catch (const OutputError& error) {
        return report_failure(error.what(), ExitCode::OutputFailed);
    } catch (const std::filesystem::filesystem_error& error) {
        return report_failure(
            fmt::format("cannot access '{}': {}", error.path1().string(), error.code().message()),
            ExitCode::BadInput);
    } catch (const OutOfMemory& error) {
        return report_failure(std::string("out of memory: ") + error.what(),
                              ExitCode::InternalFailure);
    } catch (const std::bad_alloc&) {
        return report_failure(
            "out of memory: use smaller images, fewer maps, fewer bubbles or fewer --threads",
            ExitCode::InternalFailure);
    } catch (const std::exception& error) {
        return report_failure(std::string("internal failure: ") + error.what(),
                              ExitCode::InternalFailure);
    }
}

}  // namespace foam::texgen
