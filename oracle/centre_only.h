/// For references whose programs sample a pixel at its centre alone.
#pragma once

#include <string>

#include "oracle/oracle_error.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Throws OracleError for a view that is sampled elsewhere.
inline void require_centre(const View& view, const std::string& reference) {
    if (view.sample.offset_px != glm::dvec2(0))
        throw OracleError(
            reference +
            " samples pixels at their centres only; expected zproof, embree or vulkan for sample " +
            sample_word(view.sample));
}

}  // namespace zproof::oracle
