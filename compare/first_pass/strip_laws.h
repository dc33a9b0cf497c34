/// Looks up the laws of what a strip shows.
#pragma once

#include <bit>

#include "compare/first_pass/shown_triangles.h"
#include "compare/strips/kernel.h"
#include "compare/strips/strip.h"

namespace zproof {

/// One thread at a time; all must outlive it.
class StripLaws {
  public:
    StripLaws(const Scene& scene, const strips::Kernel& kernel, ShownTriangles& shown)
        : triangle_count_(scene.triangles.size()), kernel_(kernel), shown_(shown) {}

    /// Of a strip whose ids were compared: once for every run of pixels at which the candidate shows the
    /// same, and for every triangle that the reference shows where they differ.
    void look_up(Strip& strip) const {
        std::uint32_t* law = strip.law_of_run.data();
        for (Strip::Pixels rest = strip.turns; rest != 0; rest &= rest - 1)
            *law++ = law_of(strip.candidate.primitive[std::countr_zero(rest)]);
        look_up_others(strip);
    }
    /// Of runs in the chunks of some pixels; other runs have none.
    void look_up_around(Strip& strip, Strip::Pixels pixels) const;

  private:
    std::uint32_t law_of(PrimitiveId triangle) const {
        return std::size_t(triangle) < triangle_count_ ? shown_.place_of(triangle) : 0;
    }
    void look_up_others(Strip& strip) const {
        strip.others.count = 0;
        if (strip.differ != 0) look_up_what_differs(strip);
    }
    void look_up_what_differs(Strip& strip) const;

    std::size_t triangle_count_;
    const strips::Kernel& kernel_;
    ShownTriangles& shown_;
};

}  // namespace zproof
