/// --sample: where within its pixels a view is sampled (docs/samples.md).
#pragma once

#include <string>
#include <vector>

#include "scenes/view.h"

namespace zproof {

/// "DX,DY", "standard:COUNT" or "standard:COUNT:INDEX". Throws UsageError.
std::vector<Sample> samples_from_word(const std::string& word);

/// Every view at each of the samples.
std::vector<View> at_samples(const std::vector<View>& views, const std::vector<Sample>& samples);

bool is_centre(const Sample& sample);

/// The view's name in results, no two alike: "door", "door.sample-2" of a pattern, "door.at_-0.25_0.125".
std::string shown_name(const View& view);

/// "sampled at (-0.25, 0.125) px from each pixel's centre"; empty for the centre.
std::string sample_note(const Sample& sample);

}  // namespace zproof
