/// What a study knows of every pixel, as OpenEXR files for other programs.
#pragma once

#include <filesystem>
#include <string>

#include "filters/report/evidence_planes.h"
#include "filters/study/plan.h"
#include "image_io/image_io.h"

namespace zproof {

/// Told by study::ProgressSink, in its order. The folder must be there.
class EvidenceFiles {
  public:
    EvidenceFiles(std::filesystem::path folder, FileFacts facts)
        : folder_(std::move(folder)), facts_(std::move(facts)) {}

    /// surface.exr: half_width, major, minor, angle_degrees, lod, u, v, du_dx, dv_dx, du_dy, dv_dy (float32),
    /// and region (uint32), a bit for each region of the attribute "zproof:regions", the first the least.
    /// Texels.
    void begin(const study::ViewEvidence& known);
    /// METHOD-error.exr: R, G and B of picture less truth, and flip.
    void map(const std::string& label, const PictureMetric& metric, const Plane<double>& map);
    void show(const std::string& label, const Picture& picture);
    /// NAME-permitted.exr: least.R to greatest.B, and outside: how far the worst channel lies outside, linear
    /// light. The attributes "zproof:claim" and "zproof:promise" name the method and its promise.
    void claim(const ClaimedPicture& claimed) const;

  private:
    std::filesystem::path folder_;
    FileFacts facts_;
    Picture truth_, error_;  ///< of the method in hand
};

}  // namespace zproof
