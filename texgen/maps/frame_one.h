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

/// Frame 1 of an animation, and the colors that a picture has under the bubbles of this frame. All
/// frames of the animation share one object of this class. Frame 1 and the colors are therefore
/// computed only once, and only if a map needs them. The class is thread-safe.
class FrameOne {
  public:
    /// `make` returns frame 1. Only the first thread that needs frame 1 calls `make`.
    explicit FrameOne(std::function<std::shared_ptr<const Frame>()> make)
        : make_(std::move(make)) {}

    explicit FrameOne(std::shared_ptr<const Frame> frame)
        : FrameOne([frame = std::move(frame)] { return frame; }) {}

    const Frame& frame() const {
        std::call_once(made_, [this] { frame_ = make_(); });
        return *frame_;
    }

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
    std::function<std::shared_ptr<const Frame>()> make_;
    mutable std::once_flag made_;
    mutable std::shared_ptr<const Frame> frame_;
    mutable std::mutex mutex_;  // protects the members below
    mutable std::shared_ptr<const SourcePicture> picture_;
    mutable std::shared_ptr<const ColorsByIdentity> colors_;
};

}  // namespace foam::texgen
