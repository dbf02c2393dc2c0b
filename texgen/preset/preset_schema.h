// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/keys/value.h"

#include <string>

namespace foam::texgen {

/// Returns a value as JSON. A date or a time becomes a text, and a table an empty object, because
/// its entries are not part of the value.
Json to_json(const Value& value);

/// Returns the JSON Schema (draft 2020-12) of preset files as indented text. A table is an object
/// whose properties are the keys of the table. The schema of a key contains its type, its range or
/// choices, its default and its description. The events are an array; each item must match the
/// schema of one kind of event (`anyOf`). Some annotations are not part of JSON Schema. `x-unit` is
/// the unit of a number or of all numbers of a list. `x-only-for`, `x-used-with` and
/// `x-unused-with` name another key and some of its values. With `x-only-for`, the key must keep
/// its default unless the other key has one of these values. With `x-used-with`, the
/// key has an effect only if the other key has one of these values; with `x-unused-with`, it has
/// none in this case. `x-below` names another key, whose number must be larger.
///
/// The schema accepts every preset file that the program accepts. Validators ignore the
/// annotations. Therefore only the program checks conditions between several keys.
std::string preset_schema();

}  // namespace foam::texgen
