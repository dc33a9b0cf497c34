#include "reports/evidence.h"

#include <tbb/parallel_invoke.h>

#include <fstream>
#include <ostream>
#include <string>

#include "frame/exr.h"
#include "frame/png.h"
#include "reports/pictures.h"
#include "reports/wording.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw ReportError(folder.string() + ": cannot make the folder: " + failure.message());
}

/// NAME.png and NAME-small.png.
void write_pictures(const fs::path& folder, const std::string& name, const Plane<Rgb8>& picture) {
    write_png(folder / (name + ".png"), picture);
    write_png(folder / (name + "-small.png"), thinned(picture, shrink_factor(picture.size())));
}

void write_class_maps(const fs::path& folder, const Plane<PixelClass>& classes) {
    write_png(folder / "class.png", picture_of_classes(classes));
    write_png(folder / "class-small.png", picture_of_classes(small_class_map(classes)));
}

void write_findings_file(const fs::path& file, const Verdict& verdict) {
    std::ofstream out(file, std::ios::binary);
    write_findings(out, verdict);
    out.close();
    if (!out) throw ReportError(file.string() + ": cannot be written; is the disk full?");
}

}  // namespace

void write_view_evidence(const fs::path& folder, const Frame& candidate, const Frame& reference,
                         const Verdict& verdict) {
    make_folder(folder);
    tbb::parallel_invoke([&] { write_exr(folder / "candidate.exr", candidate); },
                         [&] { write_exr(folder / "reference.exr", reference); },
                         [&] { write_pictures(folder, "id", picture_of_ids(candidate.primitive)); },
                         [&] { write_pictures(folder, "reference-id", picture_of_ids(reference.primitive)); },
                         [&] { write_pictures(folder, "depth", picture_of_depths(candidate.camera_depth)); },
                         [&] { write_class_maps(folder, verdict.classes); },
                         [&] { write_findings_file(folder / "findings.csv", verdict); });
}

void write_witness_frame(const fs::path& folder, const std::string& witness, const Frame& frame) {
    write_exr(folder / (witness + ".exr"), frame);
}

void write_colours(const fs::path& folder, const Picture& picture) {
    write_exr(folder / "colour.exr", picture);
    write_pictures(folder, "colour", picture_of_light(picture));
}

void write_witness_picture(const fs::path& folder, const std::string& witness, const Picture& candidate,
                           const Picture& picture) {
    write_exr(folder / (witness + "-colour.exr"), picture);
    write_pictures(folder, witness + "-colour", picture_of_light(picture));
    write_pictures(folder, witness + "-difference", picture_of_difference(candidate, picture));
}

void write_findings(std::ostream& out, const Verdict& verdict) {
    out << "x,y,class,candidate_id,reference_id,candidate_depth,reference_depth,eps_px,depth_low,depth_truth,"
           "depth_high,error_over_bound\n";
    for (const Finding& f : verdict.findings)
        out << f.x << ',' << f.y << ',' << name_of(f.verdict) << ',' << id_text(f.candidate.primitive) << ','
            << id_text(f.reference.primitive) << ',' << shortest(f.candidate.camera_depth) << ','
            << shortest(f.reference.camera_depth) << ',' << shortest(f.eps_px) << ','
            << shortest(f.candidate_depth.low) << ',' << shortest(f.candidate_depth.truth) << ','
            << shortest(f.candidate_depth.high) << ',' << shortest(f.error_over_bound) << '\n';
}

}  // namespace zproof
