#include "tests/reports/sample.h"

#include "reports/evidence.h"
#include "reports/view_picture.h"

#include <cmath>
#include <limits>

namespace zproof {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Finding hole_at(int x, int y, PrimitiveId covering) {
    return {.x = x,
            .y = y,
            .verdict = PixelClass::hole,
            .candidate = {},
            .reference = {covering, 0.1f},
            .eps_px = 1.0 / 512 + 1e-7,
            .candidate_depth = {nan, nan, nan},
            .error_over_bound = nan};
}

ViewResult view_of(const std::string& scene, const std::string& source, const std::string& view) {
    ViewResult v;
    v.scene = scene;
    v.source = source;
    v.view = view;
    return v;
}

ViewResult meadow() {
    ViewResult v = view_of("meadow", "suite", "dawn");
    v.reason = "Grass of a pixel's width.";
    v.width = 1920;
    v.height = 1080;
    v.triangles = 1'000'000;
    v.candidate = "zproof";
    v.reference = "embree";
    v.counts[std::size_t(PixelClass::agree)] = 1920 * 1080 - 7;
    v.counts[std::size_t(PixelClass::edge)] = 7;
    v.candidate_depth.max_error_over_bound = 0.93;
    v.candidate_depth.histogram[0] = 1'234'567;
    v.candidate_edges.max_error_over_bound = 0.875;
    v.candidate_edges.histogram[17] = 1;
    v.reference_edges.max_error_over_bound = 0.25;
    v.reference_edges.histogram[5] = 2;
    v.folder = "scenes/meadow-dawn";
    v.times = {.load = 0.25, .render = 0.125, .reference_build = 0.5, .reference = 1, .judge = 2, .write = 4};
    return v;
}

ViewResult room() {
    ViewResult v = meadow();
    v.scene = "room";
    v.view = "corner";
    v.outcome = Outcome::defective;
    v.counts[std::size_t(PixelClass::hole)] = 2;
    v.candidate_depth.max_error_over_bound = std::numeric_limits<double>::infinity();
    v.candidate_depth.histogram[20] = 3;
    v.worst = {{hole_at(812, 344, PrimitiveId(0xFFFF'FFFE)),
                "Background, but triangle 4294967294 covers <it>.", "zproof explain room 812 344"},
               {hole_at(1, 2, PrimitiveId((1u << 24) + 1)), "Background & nothing else.",
                "zproof explain room 1 2"}};
    v.worst[1].finding.reference.camera_depth = -std::numeric_limits<float>::quiet_NaN();
    v.worst[1].finding.eps_px = std::nextafter(0.1, 1.0);
    v.diagnosis =
        Diagnosis{.defects = 2,
                  .cause = Explanation{"a row is <lost>", "Whole rows are & stay background.", 2, 2, 0, 90,
                                       "Look at <rows>.", 0.875},
                  .further = {{"a <tile> is lost", "Whole tiles are background.", 1, 1, 0, 9, "", 1}},
                  .runners_up = {{"only 4 sub-pixel bits", "Declared: 8.", 1, 2, 3, 1000, "", 0.5}}};
    v.diagnosis->further[0].fitted = "1 of <16>";
    v.notes = {"3 lines were skipped."};
    v.attributes = {"bary"};
    v.oracles = {OracleResult{.name = "povray", .absent = "", .worst = {v.worst[0]}},
                 OracleResult{.name = "opengl", .absent = "no <device>"}};
    v.oracles[0].worst[0].explanation = "The <oracle> is wrong.";
    v.oracles[0].worst[0].command = "zproof explain room 812 344 --renderer povray";
    v.oracles[0].counts[std::size_t(PixelClass::hole)] = 5;
    v.oracles[0].picture.emplace();
    v.oracles[0].picture->at(0) = {.pixels = 7, .rms = 0.5, .mean = 0.25, .largest = 1};
    v.oracles[0].no_picture = "no <canvas>";
    v.oracles[0].sample = SampledPixels{700, 5, 6, 9, 1, "<many> triangles"};
    v.oracles[0].depth.max_error_over_bound = 0.125;
    v.id_agreement = {.same = {{9, 8, 7}, {8, 9, 6}, {7, 6, 9}}, .unanimous = 5};
    v.folder = "scenes/room-corner";
    return v;
}

ViewResult refused() {
    ViewResult v = view_of(hostile_name, "a.glb", "0");
    v.outcome = Outcome::unreadable;
    v.message = "a.glb: accessor 3 ends beyond its buffer; export the file again";
    return v;
}

ViewResult empty() {
    ViewResult v = view_of("empty", "empty.gltf", "0");
    v.outcome = Outcome::not_judged;
    v.message = "the scene holds no triangles";
    v.reference = "embree";
    return v;
}

}  // namespace

SampleView sample_view() {
    SampleView s{Frame({8, 4}), Frame({8, 4}), {}};
    for (Frame* frame : {&s.candidate, &s.reference})
        for (int y = 1; y < 4; ++y)
            for (int x = 1; x < 7; ++x) {
                frame->primitive.at(x, y) = PrimitiveId(std::uint32_t(x / 4));
                frame->camera_depth.at(x, y) = 2.0f + 0.1f * float(x);
            }
    s.candidate.primitive.at(6, 1) = PrimitiveId::none;
    s.candidate.camera_depth.at(6, 1) = background_depth;
    s.candidate.primitive.at(2, 3) = PrimitiveId((1u << 24) + 1);
    s.verdict.classes = Plane<PixelClass>({8, 4}, PixelClass::agree);
    s.verdict.classes.at(6, 1) = PixelClass::hole;
    s.verdict.classes.at(2, 3) = PixelClass::edge;
    s.verdict.findings = {hole_at(6, 1, PrimitiveId(1)),
                          {.x = 2,
                           .y = 3,
                           .verdict = PixelClass::edge,
                           .candidate = {PrimitiveId((1u << 24) + 1), 2.2f},
                           .reference = {PrimitiveId(0), 2.2f},
                           .eps_px = 0.002,
                           .candidate_depth = {2.1, 2.2, 2.3},
                           .error_over_bound = 0.5}};
    return s;
}

void write_sample_evidence(const std::filesystem::path& folder) {
    const SampleView sample = sample_view();
    const Plane<PixelClass>& classes = sample.verdict.classes;
    const auto picture = [&](PictureSize size) {
        return view_picture(
            classes, sample.candidate.primitive,
            [](int, int) {
                return LinearRgb{1, 1, 1};
            },
            size);
    };
    write_view_summary(folder, picture(card_picture), sample.verdict);
    write_view_evidence(folder, sample.candidate, sample.reference, sample.verdict);
    write_large_picture(folder, picture(large_picture));
}

Results sample_results() {
    Results results;
    results.version = "0.1.0";
    results.commit = "22ec5f20a1b2, changed";
    results.command = "zproof run";
    results.compiler = "g++ 12";
    results.embree = "Embree 3.13.5 (AVX2)";
    results.threads = 2;
    results.renderers = {{"zproof", "0.1.0", R"({"kind":"raster","subpixel_bits":8})"},
                         {"povray", "3.7 <b>", R"({"kind":"ray"})"}};
    results.views = {meadow(), room(), refused(), empty()};
    return results;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + part.size()))
        ++count;
    return count;
}

}  // namespace zproof
