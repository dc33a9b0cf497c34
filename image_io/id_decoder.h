/// A stored number as the id of one of the scene's triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "frame/convention.h"
#include "frame/frame.h"
#include "image_io/module_table.h"

namespace zproof::image_io {

/// Where a sample stands in its file.
struct SamplePlace {
    int x = 0, y = 0;
};

class IdDecoder {
  public:
    /// `channel` is what errors call the source.
    IdDecoder(const Convention& convention, Sample sample, std::string channel);

    /// Throws FrameError for a number that is neither the background's nor a triangle's.
    PrimitiveId id_of(std::int64_t number, SamplePlace place) const;
    /// Throws FrameError, beside that, for a number that is not whole, or so large that the sample's type has
    /// no room for its neighbours.
    PrimitiveId id_of_real(double number, SamplePlace place) const;

  private:
    [[noreturn]] void refuse(const std::string& number, SamplePlace place, const std::string& expected) const;

    std::int64_t base_;
    std::optional<std::int64_t> background_;
    double exact_below_;  ///< whole numbers up to here are all there are
    std::string channel_;
};

}  // namespace zproof::image_io
