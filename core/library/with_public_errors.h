// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "core/io/format_error.h"

#include <foamtex/errors.h>

#include <stdexcept>
#include <system_error>

namespace foam {

/// Returns work(). If work() throws InputError, FormatError, OutputError, std::invalid_argument or
/// std::system_error, throws instead an exception of the installed libraries (foamtex/errors.h)
/// with the same message. All other exceptions stay unchanged.
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
