// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns the JSON Schema (draft 2020-12) of a preset's TOML, as an indented text. Tables are
/// objects whose properties are the keys, with type, range or choices, default and description.
/// Events are an array of `anyOf` their kinds. Three annotations are not part of JSON Schema:
/// `x-unit` is the unit of a number, `x-only-for` names another key and the values that it must
/// have, and `x-below` names the key whose number must be larger.
///
/// The schema accepts every preset that the program accepts, except for a preset that relies on
/// `--set`. It does not express rules that concern several keys; the program checks these as well.
std::string preset_schema();

}  // namespace foam::texgen
