// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/difference_limits.h"
#include "texgen/keys/key.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// One or more percentile limits, separated by commas. Each is written like "99.9=0.01": at least
/// 99.9 percent of the pixels differ by at most 0.01. This struct is one of the kinds of values
/// that keys accept (keys/value_kinds.h).
struct PercentileLimits {
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::vector<PercentileLimit>& member) const;
    std::optional<Value> write(const std::vector<PercentileLimit>& member) const;
};

/// Returns the keys of all limits: fail, fail_percent, ..., warn, warn_percent, ... The options of
/// `compare` and the keys of a file of tolerances are derived from this list. KeyInfo::meaning
/// describes the limit.
const Keys<CompareLimits>& limit_keys();

/// Returns true if the key is a limit of warnings, not of failures.
bool is_warning_key(const KeyInfo& key);

/// Returns true if the key is a limit of angles, which applies only to pictures of normals.
bool is_angle_key(const KeyInfo& key);

/// Returns the name of the option of the command line for a key: "--fail-rms" for fail_rms.
std::string option_name(const KeyInfo& key);

/// Returns an argument of the command line as a value. The value is an integer if the whole text is
/// an integer, a number if the whole text is another number, otherwise a string.
Value value_of_argument(const std::string& text);

}  // namespace foam::texgen
