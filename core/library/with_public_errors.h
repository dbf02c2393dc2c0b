// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "core/io/format_error.h"

#include <foamtex/errors.h>

#include <stdexcept>
#include <system_error>

namespace foam {

/// Returns work(). Exceptions that the program throws on purpose, and errors of the operating
/// system, become the exceptions of the library (foamtex/errors.h).
template <class Work>
auto with_public_errors(const Work& work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw foamtex::InputError(error.what());
    } catch (const FormatError& error) {
        throw foamtex::InputError(error.what());
    } catch (const OutputError& error) {
        throw foamtex::OutputError(error.what());
    } catch (const std::invalid_argument& error) {
        throw foamtex::ArgumentError(error.what());
    } catch (const std::system_error& error) {  // also std::filesystem::filesystem_error
        throw foamtex::OutputError(error.what());
    }
}

}  // namespace foam
