/// Gathers what the viewer shows of a view while the view is studied.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "filters/commands/pictures.h"
#include "filters/report/crops.h"
#include "filters/report/evidence_planes.h"
#include "filters/study/inspection.h"
#include "filters/study/plan.h"
#include "filters/study/worst_pixels.h"

namespace zproof {

/// A view under study, and the word that its scene was asked for by.
struct StudiedView {
    std::string scene_word, scene_name;
    const Scene& scene;
    const View& view;
    const study::Plan& plan;
    const std::vector<PictureChoice>& pictures;  ///< of others, among the plan's methods
    std::optional<CropBox> inspected{};          ///< whose every pixel is told
};

/// Throws UsageError where the box reaches beyond the view, or has more than 2^15 pixels, each method
/// counted.
void refuse_unfit_box(const CropBox& box, std::size_t methods, const View& view);

/// Told by study::ProgressSink, in its order.
class ViewEvidenceWriter {
  public:
    void begin(const study::ViewEvidence& known);
    void show(const std::string& what, const Picture& picture);  ///< before begin(): nothing
    void claim(const ClaimedPicture& claimed);                   ///< of a picture that was shown
    void map(const std::string& label, const PictureMetric& metric, const Plane<double>& map);

    /// folder/planes.zvp. Throws FrameError where it cannot be written.
    void write(const std::filesystem::path& folder, const StudiedView& studied) &&;

  private:
    /// Rows of the worst pixels.
    nlohmann::json inspections(const study::Inspector& inspector, const StudiedView& studied) const;
    /// Adds what is read at every pixel of the box.
    void add_inspected(const study::Inspector& inspector, const StudiedView& studied, const CropBox& box);
    /// What pictures are of, or claim to be of.
    std::vector<study::StudyMethod> told_methods(const StudiedView& studied) const;

    std::optional<EvidencePlanes> planes_;
    Picture truth_;
    std::vector<study::Region> regions_;
    std::vector<study::MethodPixels> worst_;
};

/// "zproof filters explain worked --view phi-0 --width 256 --height 256 --truth N", quoted for a shell.
std::string explain_command_for(const StudiedView& studied);

}  // namespace zproof
