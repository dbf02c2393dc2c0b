#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the coefficients of the polynomials in trigonometric.h, trigonometric.cpp and exponential.h.

Also prints some constants of these files as sums of two doubles.

Each polynomial p minimizes the largest value of |p(z) - f(z)| * weight(z) on an interval (minimax approximation). It is
found by Remez's exchange algorithm (E. Remez, 1934) in 60 decimal digits with mpmath, and is then rounded to double
precision. The functions f have a removable singularity at z = 0, so that |z| is kept above 1e-20.
"""

from mpmath import asin, atan, cos, exp, log, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 60


def chebyshev_nodes(low, high, count):
    return [(low + high) / 2 - (high - low) / 2 * cos(pi * (2 * k + 1) / (2 * count)) for k in range(count)]


def value(coefficients, z):
    total = mpf(0)
    for c in reversed(coefficients):
        total = total * z + c
    return total


def solve(f, weight, nodes):
    """Returns the polynomial whose weighted error alternates between +e and -e at the nodes, and e."""
    size = len(nodes)
    system = matrix(size, size)
    right = matrix(size, 1)
    for row, z in enumerate(nodes):
        for power in range(size - 1):
            system[row, power] = z**power
        system[row, size - 1] = (-1) ** row / weight(z)
        right[row] = f(z)
    solution = lu_solve(system, right)
    return [solution[k] for k in range(size - 1)], solution[size - 1]


def extrema(error, low, high, count):
    """Returns the `count` alternating extrema of the error, found on a grid that is dense near the ends."""
    grid = [(low + high) / 2 - (high - low) / 2 * cos(pi * k / 600) for k in range(601)]
    values = [error(z) for z in grid]
    found = []
    for z, e in zip(grid, values):
        if not found or (e > 0) != (found[-1][1] > 0):
            found.append((z, e))
        elif abs(e) > abs(found[-1][1]):
            found[-1] = (z, e)
    while len(found) > count:
        found.pop(0 if abs(found[0][1]) < abs(found[-1][1]) else -1)
    return [z for z, _ in found]


def minimax(f, weight, low, high, count):
    nodes = chebyshev_nodes(low, high, count + 1)
    for _ in range(12):
        coefficients, level = solve(f, weight, nodes)
        nodes = extrema(lambda z: (value(coefficients, z) - f(z)) * weight(z), low, high, count + 1)
    rounded = [mpf(float(c)) for c in coefficients]
    worst = max(abs((value(rounded, z) - f(z)) * weight(z)) for z in chebyshev_nodes(low, high, 400))
    return rounded, level, worst


def show(name, f, weight, low, high, count):
    coefficients, level, worst = minimax(f, weight, mpf(low), mpf(high), count)
    print(f"// {name}: relative error 2^{float(log(worst, 2)):.1f}, 2^{float(log(abs(level), 2)):.1f} before rounding")
    for c in coefficients:
        print(f"    {float(c).hex()},  // {float(c):.17g}")


def series_safe(f):
    return lambda z: f(z if abs(z) > mpf("1e-20") else mpf("1e-20"))


if __name__ == "__main__":
    quarter = (pi / 4 * mpf("1.0001")) ** 2
    # The polynomials S, C, A and T are defined by the following formulas, with z = x²:
    # sin x = x + x z S(z), cos x = 1 - z/2 + z² C(z), asin x = x + x z A(z), atan x = x - x z T(z)
    show("sine", series_safe(lambda z: (sin(sqrt(z)) / sqrt(z) - 1) / z), lambda z: z, 0, quarter, 6)
    show("cosine", series_safe(lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2), lambda z: z**2, 0, quarter, 6)
    show("arcsine", series_safe(lambda z: (asin(sqrt(z)) / sqrt(z) - 1) / z), lambda z: z, 0, mpf("0.25"), 13)
    show("arctangent", series_safe(lambda z: (1 - atan(sqrt(z)) / sqrt(z)) / z), lambda z: z, 0, mpf("0.25"), 12)
    # exp r = 1 + r + r² E(r), where r² is at most 1/8
    half = log(2) / 2 * mpf("1.0001")
    show("exponential", series_safe(lambda r: (exp(r) - 1 - r) / r**2), lambda r: mpf(1) / 8, -half, half, 11)
    # log((1 + s) / (1 - s)) = 2 s (1 + z/3 + z² L(z)), z = s²
    largest = ((sqrt(2) - 1) / (sqrt(2) + 1) * mpf("1.0001")) ** 2
    show("logarithm", series_safe(lambda z: (log((1 + sqrt(z)) / (1 - sqrt(z))) / (2 * sqrt(z)) - 1 - z / 3) / z**2),
         lambda z: z**2, 0, largest, 8)
    for name, number in (("pi/2", pi / 2), ("log 2", log(2)), ("1/log 2", 1 / log(2)), ("1/log 10", 1 / log(10)),
                         ("2/pi", 2 / pi), ("1/3", mpf(1) / 3), ("pi", pi), ("pi/4", pi / 4)):
        high = mpf(float(number))
        print(f"// {name} = {float(high).hex()} + {float(number - high).hex()}")
