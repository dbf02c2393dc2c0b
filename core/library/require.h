// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam {

/// Throws foamtex::ArgumentError unless `holds` is true. The message has the name of an argument,
/// the allowed values and the given value: "kappa: must be finite and at least 0, but is -1".
void require(bool holds, std::string_view name, std::string_view allowed, double given);
void require(bool holds, std::string_view name, std::string_view allowed, std::string_view given);

/// Throws foamtex::ArgumentError unless an argument is from `low` to `high`. Also throws for NaN.
void require_from(std::string_view name, double given, double low, double high);

/// Throws foamtex::ArgumentError unless a number of threads is from 0 to kMaxThreads.
void require_threads(int threads);

}  // namespace foam
