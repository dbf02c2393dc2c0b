// SPDX-License-Identifier: Apache-2.0

#pragma once

// OpenEXR streams in memory, shared by exr_encode.cpp, exr_decode.cpp, exr_header.cpp and a
// benchmark.

#include "core/files/file_io.h"

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// An output stream that writes to a buffer of the caller, at the current position. The buffer
/// grows if a write goes beyond its end.
class ExrOutput : public Imf::OStream {
  public:
    explicit ExrOutput(Bytes& bytes) : Imf::OStream("EXR"), bytes_(bytes) {}

    void write(const char data[], int count) override {
        const auto end = position_ + static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), end));
        std::copy_n(reinterpret_cast<const std::byte*>(data), count, bytes_.data() + position_);
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

  private:
    Bytes& bytes_;
    std::size_t position_ = 0;
};

/// An input stream that reads from a span of bytes. The bytes must outlive the stream.
class ExrInput : public Imf::IStream {
  public:
    explicit ExrInput(std::span<const std::byte> bytes) : Imf::IStream("EXR"), bytes_(bytes) {}

    /// Copies the next `count` bytes to `data`. Returns false if the stream ends after them. Throws
    /// Iex::InputExc if fewer than `count` bytes are left.
    bool read(char data[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (count < 0 || position_ > bytes_.size() || size > bytes_.size() - position_) {
            throw Iex::InputExc("unexpected end of the data");
        }
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(position_),
                    count,
                    reinterpret_cast<std::byte*>(data));
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

  private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

}  // namespace foam::texgen
