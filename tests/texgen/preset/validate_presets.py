#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Validates presets in TOML by a JSON Schema. Prints a line for each value that does not conform.

Usage: validate_presets.py SCHEMA PRESET...
Exit codes: 0 if all presets conform, 1 if some do not, 2 if the schema itself is invalid.
"""
import json
import sys
import tomllib

import jsonschema


def main() -> int:
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    try:
        jsonschema.Draft202012Validator.check_schema(schema)
    except jsonschema.SchemaError as error:
        print(f"{sys.argv[1]}: {error.message}")
        return 2
    validator = jsonschema.Draft202012Validator(schema)
    bad = 0
    for path in sys.argv[2:]:
        with open(path, "rb") as file:
            preset = tomllib.load(file)
        for error in validator.iter_errors(preset):
            print(f"{path}: {error.json_path}: {error.message}")
            bad += 1
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
