// SPDX-License-Identifier: Apache-2.0

#pragma once

// This file is shared by png_encode.cpp and png_decode.cpp. Only these three files of the program
// use libpng.

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <type_traits>

namespace foam::texgen {

/// Selects whether a session encodes or decodes.
enum class PngDirection { Write, Read };

/// Owns the libpng structures of one stream.
///
/// libpng reports an error by a longjmp, which must not skip a stack frame whose objects have
/// destructors. Therefore all libpng calls that can fail this way are in steps. A step is a
/// callable that owns no memory and is passed to `run`. On an error, longjmp returns to `run`.
/// Objects that own memory belong to the callers of `run`, whose stack frames longjmp does not
/// skip.
class PngSession {
  public:
    explicit PngSession(PngDirection direction) : direction_(direction) {
        png_ = direction == PngDirection::Write
                   ? png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)
                   : png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
        if (info_ == nullptr) {
            destroy();
            throw std::bad_alloc();
        }
    }
    ~PngSession() { destroy(); }
    PngSession(const PngSession&) = delete;
    PngSession& operator=(const PngSession&) = delete;

    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

    /// Returns the error message of libpng for the step that failed.
    const char* error() const { return error_.data(); }

    /// Runs a step. Returns true if it succeeded, and false if libpng reported an error. After an
    /// error, only `error` and the destructor may be called. The step must be trivially
    /// destructible, because longjmp may skip its destructor.
    template <class Step>
    bool run(const Step& step) {
        static_assert(std::is_trivially_destructible_v<Step>);
        if (setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        step();
        return true;
    }

  private:
    [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
        auto& text = static_cast<PngSession*>(png_get_error_ptr(png))->error_;
        std::strncpy(text.data(), message, text.size() - 1);
        png_longjmp(png, 1);
    }

    static void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

    void destroy() {
        if (direction_ == PngDirection::Write) {
            png_destroy_write_struct(&png_, &info_);
        } else {
            png_destroy_read_struct(&png_, &info_, nullptr);
        }
    }

    PngDirection direction_;
    std::array<char, 128> error_{};
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace foam::texgen
