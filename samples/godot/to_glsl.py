#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Translates the shader of Godot to a fragment shader of GLSL ES 3.20, and prints it.

    samples/godot/to_glsl.py | glslangValidator --stdin -S frag

GLSL ES converts no types implicitly, like Godot. The built-in variables of Godot become globals, whose directions and
types are those in Godot's documentation of spatial shaders. Hints and defaults of uniforms are removed; their names are
checked against the names that Godot documents.
"""
import pathlib
import re
import sys

SHADER = pathlib.Path(__file__).resolve().with_name("foamtex_frames.gdshader")
READ = {"TIME": "float", "UV": "vec2"}
WRITTEN = {"ALBEDO": "vec3", "NORMAL_MAP": "vec3", "NORMAL_MAP_DEPTH": "float", "AO": "float", "AO_LIGHT_AFFECT": "float",
           "ROUGHNESS": "float", "METALLIC": "float", "EMISSION": "vec3"}
RENDER_MODES = {"blend_mix", "depth_draw_opaque", "cull_back", "diffuse_burley", "specular_schlick_ggx"}
HINTS = {"source_color", "hint_normal", "hint_default_black", "filter_linear_mipmap_anisotropic", "repeat_enable",
         "hint_range"}
UNIFORM = re.compile(r"^uniform (\w+) (\w+)(?: : ([^=;]+))?(?: = [^;]+)?;$")


def translate(text):
    """Returns the text of a fragment shader. Throws ValueError for an unknown render mode or hint."""
    lines = [_line(line) for line in text.splitlines()]
    variables = [f"uniform {kind} {name};" for name, kind in READ.items()]
    variables += [f"{kind} {name};" for name, kind in WRITTEN.items()]
    head = ["#version 320 es", "precision highp float;", "precision highp int;", "precision highp sampler2DArray;",
            *variables, "out vec4 result;"]
    total = " + ".join(name if kind == "float" else f"dot({name}, vec3(1.0))" for name, kind in WRITTEN.items())
    return "\n".join([*head, *lines, f"void main() {{ fragment(); result = vec4({total}); }}", ""])


def _line(line):
    if line.startswith("render_mode "):
        _check(line.removeprefix("render_mode ").rstrip(";").split(", "), RENDER_MODES, line)
        return ""
    if line.startswith(("shader_type ", "group_uniforms ")):
        return ""
    match = UNIFORM.match(line)
    if not match:
        return line
    hints = re.sub(r"\([^)]*\)", "", match[3] or "").strip()
    _check([hint.strip() for hint in hints.split(",") if hint.strip()], HINTS, line)
    return f"uniform {match[1]} {match[2]};"


def _check(words, known, line):
    unknown = [word for word in words if word not in known]
    if unknown:
        raise ValueError(f"unknown word '{unknown[0]}' in: {line}")


if __name__ == "__main__":
    sys.stdout.write(translate(SHADER.read_text(encoding="utf-8")))
