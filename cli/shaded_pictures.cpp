#include "cli/shaded_pictures.h"

#include <algorithm>
#include <cstdint>

#include "oracle/oracle_error.h"
#include "rasterizer/shading.h"
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

void paint_witness(const Easel& easel, const Picture& ours, const SummonedWitness& witness,
                   Statement& statement) {
    try {
        const Picture theirs = witness.renderer.paint(easel.docket.view, Light{});
        statement.result.picture =
            differences(ours, theirs, severer(easel.candidate_classes, statement.classes));
        write_witness_picture(easel.folder, statement.result.name, ours, theirs);
    } catch (const OracleError& e) {
        statement.result.no_picture = e.what();
    }
}

}  // namespace

void paint(const Easel& easel, const std::vector<SummonedWitness>& witnesses,
           std::vector<Statement>& statements) {
    const Scene& scene = easel.docket.scene;
    const Picture ours = rasterizer::shade(
        scene, easel.docket.view, with_ids_that_exist(easel.candidate, scene.triangles.size()), Light{});
    write_colours(easel.folder, ours);
    for (std::size_t i = 0; i < witnesses.size(); ++i)
        if (statements[i].frame && witnesses[i].renderer.paint)
            paint_witness(easel, ours, witnesses[i], statements[i]);
}

}  // namespace zproof
