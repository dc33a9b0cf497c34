/// Gathers what the viewer shows of a view while the view is studied.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "filters/commands/pictures.h"
#include "filters/report/evidence_planes.h"
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
};

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
    nlohmann::json inspections(const StudiedView& studied) const;

    std::optional<EvidencePlanes> planes_;
    Picture truth_;
    std::vector<study::Region> regions_;
    std::vector<study::MethodPixels> worst_;
};

/// "zproof filters explain worked --view phi-0 --width 256 --height 256 --truth N", quoted for a shell.
std::string explain_command_for(const StudiedView& studied);

}  // namespace zproof
