// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/event_frames.h"

namespace foam::texgen {

namespace {

// Times that differ by less than this fraction of a time step count as equal, so that rounding
// errors do not matter. For example, with steps of 0.1 the time 0.3 is reached after three steps.
constexpr double kSameTime = 1e-6;

// The number of a frame, and its foam time. The time step to frame 2 begins at the time
// frames.warm_up. Frame 1 cannot have events, so the clock starts at frame 2. The function
// advance() moves on to the next frame. The functions is_after and is_before compare the time of
// the frame with a given time.
class FrameClock {
  public:
    explicit FrameClock(const FramesOptions& frames)
        : step_(frames.time_step), growth_(frames.step_growth), time_(frames.warm_up) {
        advance();
    }

    int frame() const { return frame_; }
    bool is_after(double time) const { return time_ > time + kSameTime * step_; }
    bool is_before(double time) const { return time_ < time - kSameTime * step_; }

    void advance() {
        ++frame_;
        step_ *= frame_ > 2 ? growth_ : 1.0;
        time_ += step_;
    }

  private:
    double step_;
    double growth_;
    double time_;
    int frame_ = 1;
};

}  // namespace

std::optional<FrameSpan> frames_of(const EventBase& event, const FramesOptions& frames) {
    if (!event.time) {
        return event.frames;
    }
    const auto [from, to] = *event.time;
    FrameClock clock(frames);
    while (from < to && !clock.is_after(from) && clock.frame() <= kLastEventFrame) {
        clock.advance();
    }
    FrameSpan span{clock.frame(), clock.frame()};
    while (clock.is_before(to) && clock.frame() <= kLastEventFrame) {
        clock.advance();
    }
    span.last = clock.frame();
    span.first = from < to ? span.first : span.last;
    return span.last <= kLastEventFrame ? std::optional(span) : std::nullopt;
}

}  // namespace foam::texgen
