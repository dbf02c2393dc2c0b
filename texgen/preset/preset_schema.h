// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns the JSON Schema (draft 2020-12) of a preset's TOML, as an indented text. Tables are
/// objects whose properties are the keys, with type, range or choices, default and description;
/// `x-only-for` names another key and the values that it must have, `x-below` the key whose number
/// must be larger. Events are an array of `anyOf` their kinds.
///
/// The schema accepts every preset that the program accepts, except for a preset that relies on
/// `--set`. Rules that concern several keys are beyond a schema: the program checks more.
std::string preset_schema();

}  // namespace foam::texgen
