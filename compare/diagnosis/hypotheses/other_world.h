/// Claims decided in another scene or view than the declared ones, by the same rules and the same bounds.
///
/// Hypotheses of one question share the triangles near the asked pixels of the declared view
/// (hypothesis_check.h). Where something else is drawn altogether, triangles must be looked for anew.
#pragma once

#include <memory>

#include "compare/adjudicate/tile_work.h"
#include "compare/diagnosis/hypothesis.h"

namespace zproof {

class OtherWorld {
  public:
    /// What the candidate of `input` drew instead. The scene must outlive it, or be shared.
    OtherWorld(const DiagnosisInput& input, std::shared_ptr<const Scene> scene, const View& view);
    ~OtherWorld();
    OtherWorld(const OtherWorld&) = delete;
    OtherWorld& operator=(const OtherWorld&) = delete;

    /// Would a faultless renderer of that world be right to claim this? Not where nothing is seen there:
    /// that nothing was drawn is another hypothesis.
    bool admits(const Claim& claim);
    /// Might the candidate show that world? Of pixels, evenly spread, that show a triangle, at least half
    /// might, each by itself. Cheap: where the candidate names triangles without a search.
    bool might_be_shown();
    /// The claim; of a candidate that names no triangles with each triangle near that may stand for it.
    std::vector<Claim> readings_of(const Claim& claim);
    /// All triangles whose image comes within reach_px (at most 1) of the pixel's centre.
    Neighbourhood around(const Claim& claim, double reach_px);
    /// The depths that the claimed triangle may have at the claim's pixel.
    ReportedDepth depth_of(const Claim& claim) const;
    /// Is it a triangle of that scene, or the background?
    bool has(PrimitiveId id) const;
    const ViewBounds& bounds() const { return bounds_; }
    const Scene& scene() const { return *scene_; }

  private:
    struct Search;

    bool may_show(const Claim& claim) const;
    Search& search();

    const DiagnosisInput& input_;
    std::shared_ptr<const Scene> scene_;
    View view_;
    ViewBounds bounds_, shown_bounds_;
    std::unique_ptr<Search> search_;  ///< made when first asked for
};

/// The declared scene, which outlives every diagnosis.
std::shared_ptr<const Scene> declared_scene(const DiagnosisInput& input);

/// The hypothesis that each claim is right for which `admitted` has the depths that it may have; of
/// background, none in particular. It goes on as background before nothing, to which the judge has no
/// objection.
Hypothesis decided(const DiagnosisInput& input, Cause cause,
                   std::function<std::optional<ReportedDepth>(const Claim&)> admitted);

/// The hypothesis that what `admits` says of a claim, as it may be read in that world, is right;
/// `depth_of` says which depths it may have.
Hypothesis decided_by(const DiagnosisInput& input, Cause cause, const std::shared_ptr<OtherWorld>& world,
                      std::function<bool(const Claim&)> admits,
                      std::function<ReportedDepth(const Claim&)> depth_of);

/// The hypothesis that the frame shows that scene in that view.
Hypothesis shown_instead(const DiagnosisInput& input, Cause cause, std::shared_ptr<const Scene> scene,
                         const View& view);

}  // namespace zproof
