#include "cli/shaded_pictures.h"

#include <algorithm>
#include <cstdint>

#include "oracle/oracle_error.h"
#include "rasterizer/shader.h"
#include "reports/evidence.h"

namespace zproof {
namespace {

/// The candidate may have named triangles that do not exist; those pixels stay black.
Frame with_ids_that_exist(const Frame& frame, std::size_t triangle_count) {
    Frame sane = frame;
    for (PrimitiveId& id : sane.primitive.pixels())
        if (id != PrimitiveId::none && std::size_t(id) >= triangle_count) id = PrimitiveId::none;
    return sane;
}

void paint_oracle(const PaintContext& paint_context, const Picture& ours, const OpenedOracle& oracle,
                  OracleAnswer& answer) {
    if (answer.pixels) {
        answer.result.no_picture =
            "asked about a sample of the pixels; --oracle " + answer.result.name + " asks about all";
        return;
    }
    try {
        const Picture theirs = oracle.renderer.paint(paint_context.context.view, Light{});
        answer.result.picture =
            differences(ours, theirs, severer(paint_context.candidate_classes, answer.classes));
        write_oracle_picture(paint_context.folder, answer.result.name, ours, theirs);
    } catch (const OracleError& e) {
        answer.result.no_picture = e.what();
    }
}

}  // namespace

Plane<Rgb8> picture_of(const ViewContext& context, const Frame& candidate, const Plane<PixelClass>& classes,
                       PictureSize size) {
    const Light light{};
    const rasterizer::Shader shader(context.scene, context.view, light);
    const auto colour_at = [&](int x, int y) {
        const PrimitiveId id = candidate.primitive.at(x, y);
        return std::size_t(id) < context.scene.triangles.size() ? shader.colour_at(x, y, id) : LinearRgb{};
    };
    return view_picture(classes, candidate.primitive, colour_at, size);
}

void paint(const PaintContext& paint_context, const std::vector<OpenedOracle>& oracles,
           std::vector<OracleAnswer>& answers) {
    const Scene& scene = paint_context.context.scene;
    const Picture ours =
        rasterizer::shade(scene, paint_context.context.view,
                          with_ids_that_exist(paint_context.candidate, scene.triangles.size()), Light{});
    write_colours(paint_context.folder, ours);
    for (std::size_t i = 0; i < oracles.size(); ++i)
        if (answers[i].frame && oracles[i].renderer.paint)
            paint_oracle(paint_context, ours, oracles[i], answers[i]);
}

}  // namespace zproof
