// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns the JSON Schema (draft 2020-12) of a preset's TOML, as an indented text. Tables are
/// objects whose properties are the keys, with type, range or choices, default and description.
/// `x-only-for` names another key and the values that it must have. `x-below` names a key whose
/// number must be larger. Events are an array; the schema of an item is `anyOf` all kinds of
/// events.
///
/// The schema accepts every preset that the program accepts, except for a preset that relies on
/// `--set`. It does not express rules that concern several keys; the program checks these as well.
std::string preset_schema();

}  // namespace foam::texgen
