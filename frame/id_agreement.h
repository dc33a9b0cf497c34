/// Where several frames of one view name the same triangle. A count of facts, not a judgement.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/frame.h"

namespace zproof {

struct IdAgreement {
    std::vector<std::vector<std::uint64_t>> same;  ///< [i][j]: pixels at which frames i and j agree on the id
    std::uint64_t unanimous = 0;                   ///< pixels at which all do
};

/// All frames of one size (std::invalid_argument otherwise), at least one.
IdAgreement count_id_agreement(std::span<const Frame* const> frames);

}  // namespace zproof
