#include <algorithm>
#include <cmath>
#include <iterator>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "scenes/standard_samples.h"

namespace zproof {

namespace {

/// "+1/2", "-1", "0".
std::string step_text(double step_px) {
    if (step_px == 0) return "0";
    std::string text = step_px > 0 ? "+" : "-";
    return text += std::abs(step_px) == 0.5 ? "1/2" : "1";
}

std::string step_text(const glm::dvec2& step_px) {
    std::string text = "(";
    return text += step_text(step_px.x) + ", " + step_text(step_px.y) + ") px";
}

Hypothesis shifted(const DiagnosisInput& input, const glm::dvec2& step_px) {
    Hypothesis h = as_declared(
        input,
        {"the image is shifted by " + step_text(step_px),
         "Each pixel holds what belongs " + step_text(-step_px) + " from its centre (x right, y down).",
         "Look at where pixels are sampled: the centre is (x + 1/2, y + 1/2); look at loop bounds as well."});
    h.view = shifted_view(input.view, step_px);
    return h;
}

Hypothesis sampled(const DiagnosisInput& input, const glm::dvec2& offset_px, const Cause& cause) {
    Hypothesis h = as_declared(input, cause);
    h.view.sample.offset_px = offset_px;
    return h;
}

/// What may be wrong where a view is sampled beside the centres.
std::vector<Hypothesis> hypotheses_of_sample(const DiagnosisInput& input) {
    const auto& [index, count, offset_px] = input.view.sample;
    if (offset_px == glm::dvec2(0)) return {};
    const char* axes = "Look at the table of sample positions: x is to the right, y is down.";
    std::vector<Hypothesis> all{
        sampled(input, {0, 0},
                {"pixels are sampled at their centres",
                 "Each pixel holds what belongs to its centre, not to the sample.",
                 "Look at where the sample's offset is added."}),
        sampled(input, {offset_px.x, -offset_px.y},
                {"the sample's y is up",
                 "Each pixel holds what belongs as far above its centre as the sample lies below.", axes}),
        sampled(input, {offset_px.y, offset_px.x},
                {"the sample's x and y are swapped",
                 "Each pixel holds what belongs to the sample (dy, dx) from its centre.", axes})};
    for (const Sample& other : standard_samples(count))
        if (other.index != index)
            all.push_back(sampled(input, other.offset_px,
                                  {"it is sample " + std::to_string(other.index),
                                   "Each pixel holds what belongs to another sample of the pattern.",
                                   "Look at which sample is resolved or read back."}));
    return all;
}

using Place = std::pair<int, int>;

/// Pixel (x, y) holds what belongs to from(x, y).
template <class From>
Hypothesis rearranged(const DiagnosisInput& input, const Cause& cause, From from) {
    Hypothesis h = as_declared(input, cause);
    h.restate = [from](const Claim& claim) -> std::optional<Claim> {
        const Place place = from(claim.x, claim.y);
        return Claim{place.first, place.second, claim.answer};
    };
    return h;
}

/// Rows stand so many pixels apart in the file, and fewer or more were supposed.
std::vector<Hypothesis> hypotheses_of_row_pitch(const DiagnosisInput& input) {
    const int wide = input.view.width;
    std::vector<int> pitches{wide - 1, wide + 1};
    for (const int multiple : {4, 8, 16, 32, 64})
        pitches.push_back((wide + multiple - 1) / multiple * multiple);
    std::ranges::sort(pitches);
    pitches.erase(std::unique(pitches.begin(), pitches.end()), pitches.end());
    std::erase_if(pitches, [&](int pitch) { return pitch == wide || pitch < 1; });
    std::vector<Hypothesis> all;
    for (const int pitch : pitches) {
        const std::string apart = std::to_string(pitch) + " pixels apart";
        const char* look_at = "Look at the row pitch (stride) of the buffer that is read back.";
        all.push_back(rearranged(
            input,
            {"rows are read without their padding",
             "Rows are stored " + apart + ", and read " + std::to_string(wide) + " apart.", look_at},
            [=](int x, int y) {
                const int at = y * wide + x;
                if (at % pitch >= wide) return Place{x, y};  // padding, which may hold anything
                return Place{at % pitch, at / pitch};
            }));
        all.push_back(rearranged(
            input,
            {"rows are read with padding that they do not have",
             "Rows are stored " + std::to_string(wide) + " pixels apart, and read " + apart + ".", look_at},
            [=](int x, int y) {
                const int at = y * pitch + x;
                return Place{at % wide, at / wide};
            }));
    }
    return all;
}

}  // namespace

View shifted_view(const View& view, const glm::dvec2& step_px) {
    View shifted = view;
    Window& w = shifted.camera.window;
    const double du = step_px.x * (w.right - w.left) / view.width;
    const double dv = step_px.y * (w.top - w.bottom) / view.height;
    w = {w.left - du, w.right - du, w.bottom + dv, w.top + dv};
    return shifted;
}

std::vector<Hypothesis> hypotheses_of_place(const DiagnosisInput& input) {
    const int right = input.view.width - 1, lowest = input.view.height - 1;
    const char* exchanged = "Look at indices such as y * width + x: rows and columns are exchanged.";
    std::vector<Hypothesis> all{
        rearranged(input,
                   {"the image is flipped in y", "Row y holds what belongs to row H - 1 - y.",
                    "Look at the viewport transform and at how rows are written: row 0 is the top."},
                   [=](int x, int y) {
                       return Place{x, lowest - y};
                   }),
        rearranged(input,
                   {"the image is flipped in x", "Column x holds what belongs to column W - 1 - x.",
                    "Look at the camera's right axis, or its cross product's order."},
                   [=](int x, int y) {
                       return Place{right - x, y};
                   }),
        rearranged(input,
                   {"the image is turned by half a turn",
                    "Pixel (x, y) holds what belongs to (W - 1 - x, H - 1 - y).",
                    "Look at the viewport transform and the camera's axes: both are negated."},
                   [=](int x, int y) {
                       return Place{right - x, lowest - y};
                   }),
        rearranged(input,
                   {"the image is transposed", "Pixel (x, y) holds what belongs to (y, x).", exchanged},
                   [](int x, int y) {
                       return Place{y, x};
                   })};
    for (const int aside : {-1, 1})
        all.push_back(rearranged(input,
                                 {"the image is flipped in y, a row aside",
                                  aside > 0 ? "Row y holds what belongs to row H - y."
                                            : "Row y holds what belongs to row H - 2 - y.",
                                  "Look at how rows are written: the last one is H - 1."},
                                 [=](int x, int y) {
                                     return Place{x, lowest + aside - y};
                                 }));
    if (right == lowest) {
        const char* turned =
            "Look at the picture's orientation, and at the order of a transposition and a flip.";
        all.push_back(rearranged(input,
                                 {"the image is turned by a quarter turn, clockwise",
                                  "Pixel (x, y) holds what belongs to (y, W - 1 - x).", turned},
                                 [=](int x, int y) {
                                     return Place{y, right - x};
                                 }));
        all.push_back(rearranged(input,
                                 {"the image is turned by a quarter turn, counterclockwise",
                                  "Pixel (x, y) holds what belongs to (W - 1 - y, x).", turned},
                                 [=](int x, int y) {
                                     return Place{right - y, x};
                                 }));
    }
    const int wide = right + 1, high = lowest + 1;
    all.push_back(rearranged(input,
                             {"columns are stored, and read as rows",
                              "Pixels follow each other from column to column in the file.", exchanged},
                             [=](int x, int y) {
                                 return Place{(y * wide + x) / high, (y * wide + x) % high};
                             }));
    all.push_back(rearranged(input,
                             {"rows are stored, and read as columns",
                              "Pixels follow each other from row to row in the file.", exchanged},
                             [=](int x, int y) {
                                 return Place{(x * high + y) % wide, (x * high + y) / wide};
                             }));
    all.push_back(rearranged(input,
                             {"the image is transposed and stretched",
                              "Pixel (x, y) holds what belongs to (y W / H, x H / W).", exchanged},
                             [w = right + 1, h = lowest + 1](int x, int y) {
                                 return Place{y * w / h, x * h / w};
                             }));
    for (const double size : {1.0, 0.5})
        for (const int dy : {0, -1, 1})
            for (const int dx : {0, -1, 1})
                if (dx != 0 || dy != 0) all.push_back(shifted(input, size * glm::dvec2(dx, dy)));
    for (const auto& some : {hypotheses_of_row_pitch, hypotheses_of_sample})
        std::ranges::move(some(input), std::back_inserter(all));
    return all;
}

}  // namespace zproof
