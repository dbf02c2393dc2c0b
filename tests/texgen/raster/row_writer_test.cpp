#include "texgen/raster/row_writer.h"

#include <gtest/gtest.h>

#include <random>

namespace foam::texgen {
namespace {

// A row of stretches, and what is around it.
template <std::size_t PixelBytes>
class Row {
  public:
    Row(std::mt19937_64& random, std::uint32_t longest) {
        for (int k = 0; k < 20; ++k) {
            begins_.push_back(begins_.back() + static_cast<std::uint32_t>(random() % longest));
            const std::uint64_t bits = random() >> (64 - 8 * PixelBytes);
            pixels_.push_back(static_cast<PixelWord<PixelBytes>>(bits));
        }
        bytes_.assign(begins_.back() * PixelBytes + kPaintedBeyond + 8, kUntouched);
    }

    void paint() {
        const Stretches<PixelBytes> all{pixels_.size(), begins_.data(), pixels_.data()};
        paint_row(all, bytes_.data());
    }

    void expect_painted() const {
        for (std::size_t k = 0; k < pixels_.size(); ++k) {
            for (std::size_t at = begins_[k] * PixelBytes; at < begins_[k + 1] * PixelBytes; ++at) {
                const auto byte = static_cast<std::uint8_t>(pixels_[k] >> 8 * (at % PixelBytes));
                ASSERT_EQ(bytes_[at], byte) << PixelBytes << " bytes, stretch " << k;
            }
        }
        for (std::size_t k = bytes_.size() - 8; k < bytes_.size(); ++k) {
            ASSERT_EQ(bytes_[k], kUntouched);
        }
    }

  private:
    static constexpr std::uint8_t kUntouched = 0xA5;

    std::vector<std::uint32_t> begins_{0};
    std::vector<PixelWord<PixelBytes>> pixels_;
    std::vector<std::uint8_t> bytes_;
};

// Stretches of one pixel up to several blocks of them.
template <std::size_t PixelBytes>
void expect_painted() {
    std::mt19937_64 random(5);
    for (int round = 0; round < 200; ++round) {
        Row<PixelBytes> row(random, round % 2 == 0 ? 4 : 400);
        row.paint();
        row.expect_painted();
    }
}

TEST(PaintRow, WritesEveryStretch) {
    expect_painted<1>();
    expect_painted<2>();
    expect_painted<3>();
    expect_painted<4>();
    expect_painted<6>();
    expect_painted<8>();
}

}  // namespace
}  // namespace foam::texgen
