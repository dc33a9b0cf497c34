#include "tests/frozen/verdict_text.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>

#include "frame/frame_error.h"
#include "frame/precision_text.h"
#include "math/sha256.h"
#include "scenes/scene_hash.h"
#include "tests/frozen/judged.h"

namespace zproof::frozen {
namespace {

/// The number exactly, as printf's %a has it but for the 0x. Every NaN is the same.
std::string exactly(double number) {
    if (std::isnan(number)) return "nan";
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::hex).ptr};
}

std::string hexadecimal(std::uint32_t bits) {
    char text[9];
    return {text, std::to_chars(text, text + sizeof text, bits, 16).ptr};
}

/// "480 agree, 2 edge"
std::string runs_of(const Plane<PixelClass>& classes, int y) {
    std::string text;
    const int width = classes.size().width;
    for (int x = 0, end = 0; x < width; x = end) {
        const PixelClass c = classes.at(x, y);
        for (end = x + 1; end < width && classes.at(end, y) == c;) ++end;
        text.append(x == 0 ? "" : ", ").append(std::to_string(end - x)).append(" ").append(name_of(c));
    }
    return text;
}

std::string counts_text(const ClassCounts& counts) {
    std::string text = "counts";
    for (int c = 0; c < pixel_class_count; ++c) {
        // younger than the records, in which they do not occur
        const bool is_young =
            PixelClass(c) == PixelClass::undecidable || PixelClass(c) == PixelClass::wrong_attribute;
        if (is_young && counts[std::size_t(c)] == 0) continue;
        text.append(" ")
            .append(name_of(PixelClass(c)))
            .append("=")
            .append(std::to_string(counts[std::size_t(c)]));
    }
    return text + "\n";
}

CountsByClass counts_by_class(const ClassCounts& counts) {
    CountsByClass by_name;
    for (int c = 0; c < pixel_class_count; ++c)
        if (counts[std::size_t(c)] != 0)
            by_name[std::string(name_of(PixelClass(c)))] = counts[std::size_t(c)];
    return by_name;
}

std::string classes_text(const Verdict& verdict) {
    const Resolution size = verdict.classes.size();
    std::string text = "size " + std::to_string(size.width) + " x " + std::to_string(size.height) + "\n" +
                       counts_text(verdict.counts);
    for (int y = 0; y < size.height; ++y)
        text.append("row ").append(std::to_string(y)).append(": ").append(runs_of(verdict.classes, y)) +=
            '\n';
    return text;
}

std::string answer_text(const Answer& answer) {
    return hexadecimal(std::uint32_t(answer.primitive)) + " " +
           hexadecimal(std::bit_cast<std::uint32_t>(answer.camera_depth));
}

std::string finding_text(const Finding& f) {
    std::string text = "pixel " + std::to_string(f.x) + " " + std::to_string(f.y) + " ";
    text.append(name_of(f.verdict)).append(" candidate ").append(answer_text(f.candidate));
    text.append(" reference ").append(answer_text(f.reference)).append(" eps ").append(exactly(f.eps_px));
    text.append(" depth ").append(exactly(f.candidate_depth.low)).append(" ");
    text.append(exactly(f.candidate_depth.truth)).append(" ").append(exactly(f.candidate_depth.high));
    return text.append(" error ").append(exactly(f.error_over_bound)) + "\n";
}

template <class T>
void add_bytes(Sha256& sum, std::span<const T> values) {
    sum.add(std::uint64_t{values.size()});
    sum.add(std::as_bytes(values));
}

void add_frame(Sha256& sum, const Frame& frame) {
    sum.add(std::uint64_t(frame.size().width));
    add_bytes(sum, frame.primitive.pixels());
    add_bytes(sum, frame.camera_depth.pixels());
}

void add_camera(Sha256& sum, const Camera& c) {
    for (const double number : {double(c.eye_world.x),
                                double(c.eye_world.y),
                                double(c.eye_world.z),
                                c.right.x,
                                c.right.y,
                                c.right.z,
                                c.up.x,
                                c.up.y,
                                c.up.z,
                                c.back.x,
                                c.back.y,
                                c.back.z,
                                c.window.left,
                                c.window.right,
                                c.window.bottom,
                                c.window.top,
                                c.shear.x,
                                c.shear.y,
                                c.near_depth,
                                c.far_depth})
        sum.add(std::bit_cast<std::uint64_t>(number));
    sum.add(std::uint64_t(c.projection));
    sum.add(std::uint64_t(c.ndc_depth));
}

/// Keys that are younger than the records count only where they say something.
std::string declared_text(const Precision& precision) {
    std::string text = precision_to_json(precision);
    for (const std::string young :
         {R"(,"third_weight":"edge_function")", R"(,"nothing_behind_the_eye":false)",
          R"(,"depth_rounding":"either")", R"(,"depth_of_range":0.0)", R"(,"depth_roundings":1)",
          R"(,"depth_step":0.0)"}) {
        const std::size_t place = text.find(young);
        const bool is_of_rays =
            young.find("of_range") != std::string::npos || young.find("depth_roundings") != std::string::npos;
        const bool is_old = is_of_rays && !std::holds_alternative<RayPrecision>(precision);
        if (place != std::string::npos && !is_old) text.erase(place, young.size());
    }
    return text;
}

void add_case(Sha256& sum, const Case& c) {
    sum.add(sha256_of(*c.scene));
    add_camera(sum, c.view.camera);
    sum.add(std::uint64_t(c.view.width));
    sum.add(std::uint64_t(c.view.height));
    sum.add(declared_text(c.candidate_precision));
    sum.add(declared_text(c.reference_precision));
    add_frame(sum, c.candidate);
    add_frame(sum, c.reference);
}

}  // namespace

VerdictText text_of(const Verdict& verdict) {
    VerdictText text{classes_text(verdict), "", counts_by_class(verdict.counts)};
    for (const Finding& finding : verdict.findings)
        if (!passes(finding.verdict)) text.story += finding_text(finding);
    return text;
}

VerdictText judged_text(const Subject& subject) {
    VerdictText all;
    for (std::size_t i = 0; i < subject.cases.size(); ++i) {
        VerdictText text{"refused\n", "", {{"refused", 1}}};
        try {
            text = text_of(judged(subject.cases[i]));
        } catch (const std::invalid_argument&) {  // of frames that are none of this view's
        } catch (const FrameError&) {             // of a promise that says nothing of this view
        }
        const std::string head = "case " + std::to_string(i) + "\n";
        all.classes += head + text.classes;
        all.story += head + text.story;
        for (const auto& [name, count] : text.counts) all.counts[name] += count;
    }
    return all;
}

std::string input_sha256(const Subject& subject) {
    Sha256 sum;
    for (const Case& c : subject.cases) add_case(sum, c);
    return sum.hex();
}

}  // namespace zproof::frozen
