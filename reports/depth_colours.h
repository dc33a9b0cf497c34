/// The colours of depths: logarithm over a range, near bright, far dark blue.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/picture.h"
#include "frame/plane.h"

namespace zproof {

/// The least and the greatest finite positive depth of a picture, as bits: such floats are ordered as their
/// bits are. Both 0: there is none.
struct DepthRange {
    std::uint32_t nearest = 0, farthest = 0;
};

DepthRange range_of(const Plane<float>& depths);

/// viridis((log far - log depth) / (log far - log near)), 0.7 where all are alike. A colour has three times
/// eight bits, so some 650 depths at which it changes are all there is to know: they are found once, by
/// bisection, and no pixel takes a logarithm.
class DepthColours {
  public:
    explicit DepthColours(const DepthRange& range);

    /// The colour of a depth in the range.
    Rgb8 operator()(float depth) const;
    /// Colours a row of pixels; background dark, what is no depth (NaN, zero, negative) magenta.
    void colour(std::span<const float> depths, std::span<Rgb8> pixels) const;
    /// The first by the formula.
    Rgb8 by_formula(float depth) const;

  private:
    /// Depths from `bits` on, up to the next step, have this colour.
    struct Step {
        std::uint32_t bits;
        Rgb8 colour;
    };
    /// A depth, its colour, and in which piece of viridis that lies.
    struct RasterPosition {
        std::uint32_t bits;
        Rgb8 colour;
        std::size_t piece;
    };
    /// The colours of neighbouring depths; most buckets have one colour or two.
    struct Bucket {
        std::uint32_t before, after;  ///< colours as words (rgb_words.h); no colours where there are more
        std::uint32_t change;         ///< the first bits of `after`
        std::uint32_t first;          ///< the step that its least depth is in
    };
    /// Field by field, so that those of several depths can be looked up at once. One at least.
    struct Buckets {
        std::vector<std::uint32_t> before, after, change, first;
        void push_back(const Bucket& bucket);
    };
    Bucket bucket_from(std::uint32_t bits, std::uint32_t step) const;
    std::uint32_t look_up(std::span<const float> depths, std::uint32_t* words) const;
    const Step& step_of(std::uint32_t bits) const;
    double share_of(std::uint32_t bits) const;
    RasterPosition place_of(std::uint32_t bits) const;
    void find_steps(const RasterPosition& low, const RasterPosition& high);

    DepthRange range_;
    double log_near_ = 0, log_far_ = 0;
    std::vector<Step> steps_;  ///< ascending; two more at the end, which no depth reaches
    Buckets buckets_;
    int shift_ = 0;  ///< depths of one bucket differ in so many bits
};

}  // namespace zproof
