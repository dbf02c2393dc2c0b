// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <foamtex/export.h>

#include <stdexcept>

namespace foamtex {

/// The base of all errors that functions of foamtex's libraries throw on purpose. The message is
/// one line.
class FOAMTEX_EXPORT Error : public std::runtime_error {
  public:
    using runtime_error::runtime_error;
};

/// An argument or the value of a key is not allowed, or a preset file is unreadable or invalid.
class FOAMTEX_EXPORT ArgumentError : public Error {
  public:
    using Error::Error;
};

/// A file cannot be read, or its content or the text of a state is malformed. The message names the
/// file, if there is one, and the line, if it is known.
class FOAMTEX_EXPORT InputError : public Error {
  public:
    using Error::Error;
};

/// A file cannot be written, or the operating system reports another error. The message names the
/// file, if there is one.
class FOAMTEX_EXPORT OutputError : public Error {
  public:
    using Error::Error;
};

/// No equilibrium was found, or a loop did not close.
class FOAMTEX_EXPORT EquilibriumError : public Error {
  public:
    using Error::Error;
};

}  // namespace foamtex
