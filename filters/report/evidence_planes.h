/// What the viewer shows of one view of a filter study: planes.zvp of reports/planes, with float32 channels.
#pragma once

#include <string>
#include <vector>

#include "filters/conformance/permitted_interval.h"
#include "filters/study/evidence.h"
#include "reports/planes/container.h"
#include "reports/planes/embedded.h"

namespace zproof {

/// What holds for the whole view.
struct FilterViewFacts {
    std::string scene, view;
    std::string truth;  ///< "N" to "BH" (oracle::reconstructions)
    std::string
        explain;  ///< "zproof filters explain worked --view phi-0"; pixel and method are still missing
};

/// A picture with the method that it claims to be of.
struct ClaimedPicture {
    std::string label;            ///< of the picture
    std::string method, promise;  ///< as typed; promise empty: that of zproof's own filters
    const Picture& picture;
    const PermittedInterval& permitted;
};

/// Packs planes as they come, so that no method's picture is kept.
///
///     region            a word per pixel: bit i is region i of the header
///     truth.r .g .b     float32, linear
///     half_width        float32
///     lod major minor   float32, of the footprint; 0 where there is no texture
///     footprint.*       centre and Jacobian, texels of level 0 and texels per pixel
///     method.LABEL.r .g .b, method.LABEL.flip    the flip value in 1/255
///     claim.LABEL.least.r ...greatest.b    what the claimed method permits, of a picture with a claim
///     inspected.LABEL.ROW   to_json() of inspection_json.h, of every pixel of that row, where told
class EvidencePlanes {
  public:
    explicit EvidencePlanes(const study::ViewEvidence& evidence);

    /// A picture has the view's size; its label is unique.
    void add_picture(const std::string& label, const Picture& picture);
    /// The claim is of a picture that was added.
    void add_claim(const ClaimedPicture& claimed);
    void add_flip(const std::string& label, const Plane<double>& flip);
    void add_inspected_row(const std::string& label, int row, const nlohmann::json& inspections);

    /// `inspections`: to_json() of inspection_json.h.
    planes::Container container(const FilterViewFacts& facts, const nlohmann::json& inspections) &&;

  private:
    void add_words(const std::string& name, const std::vector<float>& values);

    Resolution size_;
    Picture truth_;
    std::vector<std::string> methods_;
    nlohmann::json regions_, claims_;
    std::vector<planes::Block> blocks_;
};

/// Blocks of every view first, then pictures, flip maps and claims, Jacobians. What a page has no room for
/// lies in a script for each picture, one for the Jacobians and one for the rest. Inspected rows are in
/// no page: each lies in a script.
planes::Tiers evidence_tiers();

}  // namespace zproof
