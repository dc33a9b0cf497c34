#include <algorithm>
#include <cmath>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "frame/number_text.h"
#include "scenes/standard_samples.h"

namespace zproof {

namespace {

/// The view whose pixels stand `factor` as far from the anchor (raster position).
View scaled_about(const View& view, const glm::dvec2& factor, const glm::dvec2& anchor) {
    View scaled = view;
    const Window& w = view.camera.window;
    const auto u = [&](double x) { return w.left + (w.right - w.left) * x / view.width; };
    const auto v = [&](double y) { return w.top - (w.top - w.bottom) * y / view.height; };
    const glm::dvec2 first = anchor - factor * anchor,
                     last = anchor + factor * (glm::dvec2(view.width, view.height) - anchor);
    scaled.camera.window = {u(first.x), u(last.x), v(last.y), v(first.y)};
    return scaled;
}

std::vector<Hypothesis> stretched(const DiagnosisInput& input) {
    const glm::dvec2 size(input.view.width, input.view.height);
    if (size.x < 2 || size.y < 2) return {};
    const glm::dvec2 wider = size / (size - 1.0), narrower = (size - 1.0) / size;
    const auto grid = [&](const std::string& name, const std::string& description, const glm::dvec2& factor,
                          const glm::dvec2& anchor) {
        Hypothesis h = as_declared(
            input,
            {"the pixel grid is " + name, description,
             "Look at how pixels become rays or NDC: divide by W, not W - 1, and add 1/2 to the index."});
        h.view = scaled_about(input.view, factor, anchor);
        return h;
    };
    const std::string larger = "The picture was drawn a pixel too small.",
                      smaller = "The picture was drawn as if a pixel larger.";
    return {grid("stretched by W/(W - 1)",
                 "The outermost pixels' centres lie on the picture's sides: rays run from corner to corner.",
                 wider, 0.5 * size),
            grid("shrunk by (W - 1)/W", "Pixels lie closer together, about the picture's centre.", narrower,
                 0.5 * size),
            grid("stretched by W/(W - 1) from the top left corner", larger, wider, {0, 0}),
            grid("shrunk by (W - 1)/W from the top left corner", smaller, narrower, {0, 0}),
            grid("stretched by W/(W - 1) from the left side", larger, {wider.x, 1}, {0, 0}),
            grid("shrunk by (W - 1)/W from the left side", smaller, {narrower.x, 1}, {0, 0}),
            grid("stretched by H/(H - 1) from the top", larger, {1, wider.y}, {0, 0}),
            grid("shrunk by (H - 1)/H from the top", smaller, {1, narrower.y}, {0, 0})};
}

/// n x n pixels show one answer. A pixel of the block is asked for that answer, half a pixel aside at most.
Hypothesis coarse(const DiagnosisInput& input, int n, bool is_first) {
    const std::string px = std::to_string(n) + " x " + std::to_string(n) + " pixels show what belongs to ";
    Hypothesis h =
        as_declared(input, {px + (is_first ? "the first" : "their common corner"),
                            is_first ? "A block of pixels shows its first pixel's answer."
                                     : "A block of pixels shows one answer, that of its centre.",
                            "Look at the shading rate, or at a picture that is drawn small and enlarged."});
    const int step = is_first ? 0 : n / 2 - 1;
    h.restate = [=](Claim claim) -> std::optional<Claim> {
        claim.x = claim.x / n * n + step;
        claim.y = claim.y / n * n + step;
        return claim;
    };
    if (!is_first) h.view = shifted_view(input.view, glm::dvec2(-0.5));
    return h;
}

/// A view that should be sampled at the centres is sampled beside them.
std::vector<Hypothesis> sampled_beside(const DiagnosisInput& input) {
    if (input.view.sample.offset_px != glm::dvec2(0)) return {};
    std::vector<Hypothesis> all;
    for (const int count : {2, 4, 8, 16})
        for (const Sample& sample : standard_samples(count)) {
            Hypothesis h = as_declared(
                input, {"pixels are sampled at sample " + std::to_string(sample.index) + " of " +
                            std::to_string(count),
                        "Each pixel holds what belongs to a sample of the standard pattern, (" +
                            px_text(sample.offset_px.x) + ", " + px_text(sample.offset_px.y) +
                            ") px from the centre.",
                        "Look at the multisample state: one sample was read instead of the pixel's centre."});
            h.view.sample.offset_px = sample.offset_px;
            all.push_back(std::move(h));
        }
    return all;
}

/// A triangle's edges around the pixel that shows it.
using Edges = std::array<Affine<double>, 3>;

constexpr std::size_t most_edges = 2'048;

/// The edges beside pixels at which another id begins, evenly spread.
std::vector<Edges> edges_at_outlines(const DiagnosisInput& input) {
    const Plane<PrimitiveId>& ids = input.candidate.frame.primitive;
    std::vector<std::pair<int, int>> outline;
    for (int y = 0; y + 1 < ids.size().height; ++y)
        for (int x = 0; x + 1 < ids.size().width; ++x)
            if (ids.at(x, y) != ids.at(x + 1, y) || ids.at(x, y) != ids.at(x, y + 1))
                outline.emplace_back(x, y);
    const ViewRays<double> rays(input.view);
    std::vector<Edges> all;
    for (std::size_t i = 0; i < outline.size(); i += outline.size() / most_edges + 1) {
        const auto [x, y] = outline[i];
        const auto id = std::size_t(ids.at(x, y));
        if (id >= input.scene.triangles.size()) continue;
        const auto image =
            image_of(rays.at(x, y), corners<double>(corners_of(input.scene, std::uint32_t(id))));
        if (image) all.push_back(image->edge);
    }
    return all;
}

std::size_t held_at(const std::vector<Edges>& all, const glm::dvec2& offset) {
    return std::size_t(std::ranges::count_if(all, [&](const Edges& edges) {
        return std::ranges::all_of(
            edges, [&](const Affine<double>& e) { return e.c + e.a * offset.x + e.b * offset.y >= 0; });
    }));
}

/// The mean of the offsets, on a grid around `middle`, at which the most triangles hold their pixel.
glm::dvec2 best_around(const std::vector<Edges>& all, const glm::dvec2& middle, double reach, double step) {
    std::size_t most = 0, count = 0;
    glm::dvec2 sum(0);
    const int steps = int(std::round(reach / step));
    for (int j = -steps; j <= steps; ++j)
        for (int i = -steps; i <= steps; ++i) {
            const glm::dvec2 offset = middle + step * glm::dvec2(i, j);
            const std::size_t held = held_at(all, offset);
            if (held < most) continue;
            if (held > most) most = held, count = 0, sum = glm::dvec2(0);
            sum += offset;
            ++count;
        }
    return sum / double(count);
}

/// Each pixel's id says on which side of three edges it was sampled. The offset from the centre at which the
/// most of them hold is sought, to 1/4096 px.
std::vector<Hypothesis> fitted_shift(const DiagnosisInput& input) {
    const std::vector<Edges> all = edges_at_outlines(input);
    glm::dvec2 offset(0);
    double reach = 1;
    for (const double step : {1.0 / 8, 1.0 / 64, 1.0 / 512, 1.0 / 4096}) {
        offset = best_around(all, offset, reach, step);
        reach = step;
    }
    if (held_at(all, offset) <= held_at(all, glm::dvec2(0)) || length(offset) > 1) return {};
    Hypothesis h = as_declared(
        input, {"the image is shifted by a fraction of a pixel",
                "Each pixel holds what belongs (" + with_digits(offset.x, 4) + ", " +
                    with_digits(offset.y, 4) + ") px from its centre: fitted to the edges.",
                "Look at the viewport transform's offset and at a jitter meant for antialiasing."});
    h.learned_bits = 2 * bits_of_a_number;
    h.fits_a_limit = true;
    h.view = shifted_view(input.view, -offset);
    return {h};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_grid(const DiagnosisInput& input) {
    std::vector<Hypothesis> all = stretched(input);
    for (const int n : {2, 4})
        for (const bool is_first : {true, false}) all.push_back(coarse(input, n, is_first));
    for (const auto& more : {sampled_beside(input), fitted_shift(input)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace zproof
