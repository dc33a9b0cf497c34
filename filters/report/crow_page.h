/// Crow 1984 as a page: the lecture's figure with the numbers beneath, and its questions answered.
#pragma once

#include <string>
#include <vector>

#include "filters/study/crow.h"
#include "filters/study/results.h"
#include "frame/picture.h"

namespace zproof {

struct CrowPicture {
    std::string label;  ///< "truth", or a method of the study
    Picture picture;
};

/// `results`: a study of one view; `pictures`: those of it that the figure shows, in order.
std::string crow_page(const study::StudyResults& results, const std::vector<CrowPicture>& pictures,
                      const study::CrowAnswers& answers);

}  // namespace zproof
