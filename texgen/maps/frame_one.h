// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/color.h"
#include "texgen/pictures/source_picture.h"

#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace foam::texgen {

/// The colors of bubbles by their identities.
using ColorsByIdentity = std::unordered_map<BubbleIdentity, LinearRgb>;

/// Frame 1 of an animation, and the colors of a picture under its bubbles. All frames of the
/// animation share an object, so that these colors are computed only once. Thread-safe.
class FrameOne {
  public:
    explicit FrameOne(std::shared_ptr<const Frame> frame) : frame_(std::move(frame)) {}

    const Frame& frame() const { return *frame_; }

    /// Returns compute(), or the earlier result if the last call was for the same picture.
    std::shared_ptr<const ColorsByIdentity> colors_under(
        const std::shared_ptr<const SourcePicture>& picture,
        const std::function<ColorsByIdentity()>& compute) const {
        const std::scoped_lock lock(mutex_);
        if (!colors_ || picture_ != picture) {
            colors_ = std::make_shared<const ColorsByIdentity>(compute());
            picture_ = picture;
        }
        return colors_;
    }

  private:
    std::shared_ptr<const Frame> frame_;
    mutable std::mutex mutex_;  // protects the members below
    mutable std::shared_ptr<const SourcePicture> picture_;
    mutable std::shared_ptr<const ColorsByIdentity> colors_;
};

}  // namespace foam::texgen
