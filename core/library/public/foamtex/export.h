// SPDX-License-Identifier: Apache-2.0

#pragma once

/// Marks what the shared libraries of foamtex export.
#define FOAMTEX_EXPORT __attribute__((visibility("default")))
