#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the layout of core/ and texgen/, and prints the number of files and lines of each folder.

Usage: tests/check_layout.py [--functions]

Fails if modules include each other in a cycle, if a source has more than 300 lines, if fewer than 85 % of the
sources have a test file of the same name, if a source or script does not name its license, or if a source calls a
function of the standard library whose results differ between machines or libraries. A module is a header together with
the source of the same name. --functions also prints the median, the 90th percentile and the maximum of
the lengths of functions; it needs Universal Ctags (Debian: universal-ctags).
"""
import collections
import os
import re
import statistics
import subprocess
import sys

LARGEST_FILE = 300  # lines
TESTED_SHARE = 0.85  # fraction of the sources
LICENSE_LINE = "SPDX-License-" "Identifier: Apache-2.0"  # in two parts, so that reuse does not read it as a license
LICENSED = (".h", ".cpp", ".in", ".py", ".sh", ".gp", ".slurm", "CMakeLists.txt", ".ci/run")
# Calls of functions and uses of types whose results IEEE 754 and the C++ standard do not define to the last bit.
UNDEFINED = re.compile(
    r"(?<![\w:])(?:std::|::)?(?:a?(?:sin|cos|tan)h?|atan2|sincos|exp(?:2|m1)?|log(?:2|10|1p|b)?|pow|cbrt|hypot|fma|erfc?|"
    r"[tl]gamma|polar|arg)[fl]?\(|std::(?:\w+_distribution|complex|shuffle|sample|reduce|transform_reduce)\b|"
    r"\blong double\b|\.(?:sin|cos|tan|exp|log|pow)\(")
ELEMENTARY = re.compile(r"core/geometry/(?:trigonometric|exponential)\.(?:h|cpp)")  # implements these functions
INCLUDE = re.compile(r'^#include "((?:core|texgen)/[^"]+)"', re.M)


def source_files():
    names = subprocess.check_output(["git", "ls-files", "core", "texgen"], text=True).split()
    return [name for name in names if name.endswith((".h", ".cpp"))]


def unlicensed_files():
    """Returns the sources and scripts of the whole checkout whose first two lines do not name the license."""
    names = subprocess.check_output(["git", "ls-files"], text=True).splitlines()
    sources = [name for name in names if name.endswith(LICENSED)]
    return [name for name in sources if not any(LICENSE_LINE in line for line in text_of(name).splitlines()[:2])]


def text_of(name):
    with open(name, encoding="utf-8") as file:
        return file.read()


def module_of(name):
    return os.path.splitext(name)[0]


def include_graph(files):
    """Returns the modules that each module includes."""
    graph = collections.defaultdict(set)
    for name in files:
        module = module_of(name)
        graph[module].update(module_of(included) for included in INCLUDE.findall(text_of(name)))
        graph[module].discard(module)
    return graph


def cycles(graph):
    """Returns the strongly connected components of more than one module (Tarjan, 1972)."""
    index, low, stack, found = {}, {}, [], []

    def visit(module):
        index[module] = low[module] = len(index)
        stack.append(module)
        for included in sorted(graph.get(module, ())):
            if included not in index:
                visit(included)
                low[module] = min(low[module], low[included])
            elif included in stack:
                low[module] = min(low[module], index[included])
        if low[module] == index[module]:
            position = stack.index(module)
            component = stack[position:]
            del stack[position:]
            if len(component) > 1:
                found.append(sorted(component))

    for module in sorted(graph):
        if module not in index:
            visit(module)
    return found


def undefined_calls(files):
    """Returns (file, line number, text) of every use of a function or a type that UNDEFINED matches."""
    found = []
    for name in files:
        if ELEMENTARY.fullmatch(name):
            continue
        for number, line in enumerate(text_of(name).splitlines(), 1):
            code = re.sub(r'"(?:\\.|[^"\\])*"', '""', line).split("//")[0]
            match = UNDEFINED.search(code)
            if match:
                found.append((name, number, match.group(0)))
    return found


def rooms_table(files):
    """Prints the number of files and lines of each folder."""
    counts = collections.defaultdict(lambda: [0, 0])
    for name in files:
        room = counts[os.path.dirname(name)]
        room[0] += 1
        room[1] += text_of(name).count("\n")
    for room in sorted(counts):
        print(f"{room:28} {counts[room][0]:4} files {counts[room][1]:6} lines")


def function_lengths(files):
    """Returns (number of lines, name and file) of every function with a body, the longest first."""
    output = subprocess.check_output(
        ["ctags", "--kinds-C++=f", "--fields=+ne", "-f", "-", *files], text=True)
    lengths = []
    for row in output.splitlines():
        fields = dict(field.split(":", 1) for field in row.split("\t")[3:] if ":" in field)
        if "end" in fields:
            lengths.append((int(fields["end"]) - int(fields["line"]) + 1, "\t".join(row.split("\t")[:2])))
    return sorted(lengths, reverse=True)


def print_functions(files):
    lengths = function_lengths(files)
    numbers = [length for length, _ in lengths]
    print(f"{len(numbers)} functions: median {statistics.median(numbers):.0f} lines, "
          f"p90 {statistics.quantiles(numbers, n=10)[-1]:.0f}, max {numbers[0]} ({lengths[0][1]})")


def main():
    files = source_files()
    rooms_table(files)
    faults = []

    for component in cycles(include_graph(files)):
        faults.append("modules include each other in a cycle: " + ", ".join(component))

    for name in files:
        lines = text_of(name).count("\n")
        if lines > LARGEST_FILE:
            faults.append(f"{name} has {lines} lines, more than {LARGEST_FILE}")

    sources = [name for name in files if name.endswith(".cpp") and not name.endswith("/main.cpp")]
    untested = [name for name in sources if not os.path.exists(f"tests/{module_of(name)}_test.cpp")]
    share = 1 - len(untested) / len(sources)
    print(f"{share:.0%} of {len(sources)} sources have a test file of the same name")
    if share < TESTED_SHARE:
        faults.append(f"fewer than {TESTED_SHARE:.0%} of the sources have a test file of the same name; without one: "
                      + ", ".join(untested))

    for name, number, text in undefined_calls(files):
        faults.append(f"{name}:{number}: '{text}' may give other results with another compiler, library or processor; "
                      "use the functions of core/geometry/elementary.h")

    for name in unlicensed_files():
        faults.append(f"{name} does not begin with the line {LICENSE_LINE}")

    if "--functions" in sys.argv[1:]:
        print_functions(files)
    for fault in faults:
        print(f"check_layout: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    sys.setrecursionlimit(10000)
    sys.exit(main())
