#include "reports/evidence.h"

#include <tbb/parallel_invoke.h>

#include <fstream>
#include <string>

#include "image_io/image_io.h"
#include "reports/pictures.h"

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

void write_findings_file(const fs::path& file, const Verdict& verdict) {
    std::ofstream out(file, std::ios::binary);
    write_findings(out, verdict);
    out.close();
    if (!out) throw ReportError(file.string() + ": cannot be written; is the disk full?");
}

}  // namespace

void write_view_summary(const fs::path& folder, const Plane<Rgb8>& picture, const Verdict& verdict) {
    make_folder(folder);
    write_webp(folder / "view.webp", picture);
    write_findings_file(folder / "findings.csv", verdict);
}

void write_view_evidence(const fs::path& folder, const Frame& candidate, const Frame& reference,
                         const Verdict& verdict) {
    const Plane<PixelClass>& classes = verdict.classes;
    tbb::parallel_invoke(
        [&] { write_frame(folder / "candidate.exr", candidate); },
        [&] { write_frame(folder / "reference.exr", reference); },
        [&] { write_pictures(folder, "id", picture_of_ids(candidate.primitive)); },
        [&] { write_pictures(folder, "reference-id", picture_of_ids(reference.primitive)); },
        [&] { write_pictures(folder, "depth", picture_of_depths(candidate.camera_depth)); },
        [&] { write_png(folder / "class.png", picture_of_classes(classes)); },
        [&] { write_png(folder / "class-small.png", picture_of_classes(small_class_map(classes))); });
}

void write_large_picture(const fs::path& folder, const Plane<Rgb8>& picture) {
    write_jpeg(folder / "view-large.jpg", picture);
}

void write_oracle_frame(const fs::path& folder, const std::string& oracle, const Frame& frame) {
    write_frame(folder / (oracle + ".exr"), frame);
}

void write_colours(const fs::path& folder, const Picture& picture) {
    write_picture(folder / "colour.exr", picture);
    write_pictures(folder, "colour", picture_of_light(picture));
}

void write_oracle_picture(const fs::path& folder, const std::string& oracle, const Picture& candidate,
                          const Picture& picture) {
    write_picture(folder / (oracle + "-colour.exr"), picture);
    write_pictures(folder, oracle + "-colour", picture_of_light(picture));
    write_pictures(folder, oracle + "-difference", picture_of_difference(candidate, picture));
}

}  // namespace zproof
