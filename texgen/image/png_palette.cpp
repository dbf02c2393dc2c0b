#include "texgen/image/png_palette.h"

#include <bit>
#include <cassert>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kSlotBits = 11;  // at most an eighth of the slots is taken
constexpr std::uint32_t kOddMultiplier = 0x9e3779b1;

/// Numbers colours in the order in which they come.
class ColorNumbers {
  public:
    /// The number of a colour, or kMaxPalette when it is one too many.
    std::size_t number_of(const PaletteColor& color) {
        if (!palette_.empty() && color == palette_[previous_]) {
            return previous_;
        }
        std::uint16_t& slot = slot_of(color);
        if (slot == 0) {
            if (palette_.size() == kMaxPalette) {
                return kMaxPalette;
            }
            palette_.push_back(color);
            slot = static_cast<std::uint16_t>(palette_.size());
        }
        previous_ = slot - 1U;
        return previous_;
    }

    const std::vector<PaletteColor>& palette() const { return palette_; }

  private:
    // One more than the number of the colour, or 0 where it belongs.
    std::uint16_t& slot_of(const PaletteColor& color) {
        const auto key = std::bit_cast<std::uint32_t>(color);
        std::size_t at = key * kOddMultiplier >> (32 - kSlotBits);
        while (slots_[at] != 0 && palette_[slots_[at] - 1U] != color) {
            at = (at + 1) % slots_.size();
        }
        return slots_[at];
    }

    std::array<std::uint16_t, std::size_t{1} << kSlotBits> slots_{};
    std::vector<PaletteColor> palette_;
    std::size_t previous_ = 0;
};

PaletteColor color_of(std::span<const std::uint8_t> pixel) {
    return {pixel[0], pixel[1], pixel[2], pixel.size() > 3 ? pixel[3] : std::uint8_t{255}};
}

}  // namespace

std::optional<IndexedImage> with_palette(ImageView<const std::uint8_t> pixels) {
    assert(pixels.channels() == 3 || pixels.channels() == 4);
    ColorNumbers numbers;
    Image<std::uint8_t> indices(pixels.width(), pixels.height(), 1);
    for (int y = pixels.height() - 1; y >= 0; --y) {
        for (int x = 0; x < pixels.width(); ++x) {
            const std::size_t number = numbers.number_of(color_of(pixels.pixel(x, y)));
            if (number == kMaxPalette) {
                return std::nullopt;
            }
            indices.pixel(x, y)[0] = static_cast<std::uint8_t>(number);
        }
    }
    return IndexedImage{numbers.palette(), std::move(indices)};
}

}  // namespace foam::texgen
