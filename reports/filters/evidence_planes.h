/// What the viewer shows of one view of a filter study: planes.zvp of reports/planes, with float32 channels.
#pragma once

#include <string>
#include <vector>

#include "reports/planes/container.h"
#include "reports/planes/embedded.h"
#include "study/filters/evidence.h"

namespace zproof {

/// What holds for the whole view.
struct FilterViewFacts {
    std::string scene, view;
    std::string truth;  ///< "N", "B" or "G"
    std::string
        explain;  ///< "zproof filters explain worked --view phi-0"; pixel and method are still missing
};

/// Packs planes as they come, so that no method's picture is kept.
///
///     region            a word per pixel: bit i is region i of the header
///     truth.r .g .b     float32, linear
///     half_width        float32
///     lod major minor   float32, of the footprint; 0 where there is no texture
///     footprint.*       centre and Jacobian, texels of level 0 and texels per pixel
///     method.LABEL.r .g .b, method.LABEL.flip    the flip value in 1/255
class EvidencePlanes {
  public:
    explicit EvidencePlanes(const study::ViewEvidence& evidence);

    /// Of the view's size; the label is unique.
    void add_picture(const std::string& label, const Picture& picture);
    void add_flip(const std::string& label, const Plane<double>& flip);

    /// `inspections`: to_json() of inspection_json.h.
    planes::Container container(const FilterViewFacts& facts, const nlohmann::json& inspections) &&;

  private:
    void add_words(const std::string& name, const std::vector<float>& values);

    Resolution size_;
    Picture truth_;
    std::vector<std::string> methods_;
    nlohmann::json regions_;
    std::vector<planes::Block> blocks_;
};

/// Blocks of every view first, then pictures, flip maps, Jacobians.
planes::Tiers evidence_tiers();

}  // namespace zproof
