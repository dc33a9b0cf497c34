#include "reports/evidence.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "frame/exr.h"
#include "frame/png_kinds.h"
#include "reports/class_colour.h"
#include "reports/depth_colours.h"
#include "reports/id_colours.h"
#include "reports/pictures.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw ReportError(folder.string() + ": cannot make the folder: " + failure.message());
}

/// NAME.png and NAME-small.png of values that `colour` knows rows of.
template <class T, class ColourRow>
void write_pictures(const fs::path& folder, const std::string& name, const Plane<T>& values, PngRows rows,
                    const ColourRow& colour) {
    const auto write = [&](const std::string& ending, const Plane<T>& shown) {
        write_png(folder / (name + ending), shown.size(), rows,
                  [&](int y, std::span<Rgb8> row) { colour(shown.row(y), row); });
    };
    write(".png", values);
    write("-small.png", thinned(values, shrink_factor(values.size())));
}

/// Likewise, of a picture.
void write_pictures(const fs::path& folder, const std::string& name, const Plane<Rgb8>& picture) {
    constexpr PngRows rows = PngRows::less_the_upper;
    write_png(folder / (name + ".png"), picture, rows);
    write_png(folder / (name + "-small.png"), thinned(picture, shrink_factor(picture.size())), rows);
}

void write_ids(const fs::path& folder, const std::string& name, const Plane<PrimitiveId>& ids) {
    write_pictures(folder, name, ids, PngRows::as_they_are, colour_ids);
}

void write_depths(const fs::path& folder, const std::string& name, const Plane<float>& depths) {
    const DepthColours colours(range_of(depths));
    write_pictures(folder, name, depths, PngRows::less_the_upper,
                   [&](std::span<const float> row, std::span<Rgb8> pixels) { colours.colour(row, pixels); });
}

/// A class is an index into the colours of all.
void write_class_map(const fs::path& file, const Plane<PixelClass>& classes) {
    auto indices = Plane<std::uint8_t>::unwritten(classes.size());
    std::ranges::transform(classes.pixels(), indices.pixels().begin(),
                           [](PixelClass c) { return std::uint8_t(c); });
    std::array<Rgb8, pixel_class_count> colours;
    for (std::size_t c = 0; c < colours.size(); ++c) colours[c] = colour_of(PixelClass(c));
    write_png(file, indices, colours);
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
    const Plane<PixelClass>& classes = verdict.classes;
    tbb::parallel_invoke([&] { write_exr(folder / "candidate.exr", candidate); },
                         [&] { write_exr(folder / "reference.exr", reference); },
                         [&] { write_ids(folder, "id", candidate.primitive); },
                         [&] { write_ids(folder, "reference-id", reference.primitive); },
                         [&] { write_depths(folder, "depth", candidate.camera_depth); },
                         [&] { write_class_map(folder / "class.png", classes); },
                         [&] { write_class_map(folder / "class-small.png", small_class_map(classes)); },
                         [&] { write_findings_file(folder / "findings.csv", verdict); });
}

void write_oracle_frame(const fs::path& folder, const std::string& oracle, const Frame& frame) {
    write_exr(folder / (oracle + ".exr"), frame);
}

void write_colours(const fs::path& folder, const Picture& picture) {
    write_exr(folder / "colour.exr", picture);
    write_pictures(folder, "colour", picture_of_light(picture));
}

void write_oracle_picture(const fs::path& folder, const std::string& oracle, const Picture& candidate,
                          const Picture& picture) {
    write_exr(folder / (oracle + "-colour.exr"), picture);
    write_pictures(folder, oracle + "-colour", picture_of_light(picture));
    write_pictures(folder, oracle + "-difference", picture_of_difference(candidate, picture));
}

}  // namespace zproof
