// Programs by the renderer contract, measured: what they are handed holds the probe scenes' triangles.
#include <gtest/gtest.h>

#include "measure/instruments.h"
#include "measure/probe.h"
#include "oracle/external.h"

namespace zproof::measure {
namespace {

using namespace std::chrono_literals;

Renderer program(const std::string& command) {
    return {.name = command,
            .render =
                [command](const Scene& scene, const View& view) {
                    return oracle::External{scene, command, 600s}.render(view);
                },
            .declared = RasterPrecision{}};
}

const std::string words = " {scene} {camera} {out}";
const std::string zbuffer = "python3 '" ZPROOF_SOURCE_DIR "/examples/zbuffer.py'" + words;

void expect_centred(const Renderer& renderer) {
    for (const Bracket& centre : pixel_centre(renderer)) {
        EXPECT_LE(centre.low, 0.5);
        EXPECT_GE(centre.high, 0.5);
    }
}

TEST(MeasuredProgram, ThePythonExampleSamplesAtPixelCentresByTheTopLeftRule) {
    expect_centred(program(zbuffer));
    for (const FillSide& side : fill_sides(program(zbuffer), Sample{}))
        EXPECT_EQ(side.owns, side.dy < 0 || (side.dy == 0 && side.dx > 0)) << side.dx << " " << side.dy;
}

TEST(MeasuredProgram, BothRayCastersSampleAtPixelCentres) {
    expect_centred(program("'" ZPROOF_RAYCASTER "'" + words));
    expect_centred(program("'" ZPROOF_CASTER "'" + words));
}

TEST(MeasuredProgram, TheCppExampleHasNoGrid) {
    EXPECT_FALSE(displacement(program("'" ZPROOF_CASTER "'" + words), Sample{}, Axis::x).grid);
}

TEST(MeasuredProgram, IsHandedASceneWithoutTrianglesToo) {
    for (const std::string& command : {zbuffer, "'" ZPROOF_CASTER "'" + words}) {
        const Frame frame = program(command).render(Scene{}, raster_view(4, 4));
        for (const PrimitiveId id : frame.primitive.pixels()) EXPECT_EQ(id, PrimitiveId::none) << command;
    }
}

}  // namespace
}  // namespace zproof::measure
