// SPDX-License-Identifier: Apache-2.0

#pragma once

/// Marks a class or a function that a shared library of foamtex exports.
#define FOAMTEX_EXPORT __attribute__((visibility("default")))
