/// Everybody who can be asked for a frame.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/convention.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "frame/precision.h"
#include "image_io/image_io.h"
#include "measure/renderer.h"
#include "renderers/choice.h"
#include "reports/results.h"
#include "scenes/light.h"
#include "scenes/pixel_lattice.h"
#include "scenes/scene.h"
#include "scenes/triangle_labels.h"
#include "scenes/view.h"

namespace zproof {

/// A view that a renderer has begun on at some of its pixels.
struct BegunSample {
    PixelLattice pixels;
    std::string fewer_because;     ///< why they are fewer than in other views; empty: they are not
    std::function<Frame()> frame;  ///< waits for it; once. OracleError where there is none
};

/// A renderer that has been handed a scene.
struct Renderer {
    std::string name;
    Precision precision;                                      ///< what it is judged by
    Projections projections;                                  ///< what it can be asked about
    std::function<Frame(const View&)> render;                 ///< OracleError where it cannot
    std::function<Picture(const View&, const Light&)> paint;  ///< empty: has no colours of its own
    /// Begins on as much of a view as a known price buys, drawn by the seed. Empty: it is asked about all
    /// pixels.
    std::function<BegunSample(const View&, std::uint64_t seed)> begin_sample;
    /// What begin_sample would take, seconds: from counts, so the same on every machine. Of one that takes
    /// more than `most_s`, any number above that.
    std::function<double(const View&, double most_s)> sample_price_s;
    /// The names of the channels of the file that it gave for this view, once it has; empty: it gives no
    /// file.
    std::function<std::vector<std::string>(const View&)> channels;
    std::shared_ptr<const TriangleLabels> labels;  ///< what its ids stand for; nothing: triangles
    Convention convention{};                       ///< how its frames were read
};

/// The names that zproof knows, its own rasterizer first.
std::vector<std::string> renderer_names();

/// Why a renderer cannot be asked on this machine; empty: it can.
std::string absence_of(const RendererChoice& choice);

/// Refuses a command line whose program is not there. Throws UsageError.
void require_program(const RendererChoice& choice);

/// What it is judged by: the word after --precision, else its own promise. Throws FrameError for a word that
/// cannot be understood.
Precision declared_precision(const RendererChoice& choice);

/// The projections that the same word says it has.
Projections declared_projections(const RendererChoice& choice);

/// How its frames are to be read. Throws FrameError for words that cannot be understood.
Convention declared_convention(const RendererChoice& choice);

/// Name, version in its own words, declared precision. Only for one that is not absent. Throws FrameError as
/// declared_precision and declared_convention do, and UsageError as require_program does.
RendererFacts facts_of(const RendererChoice& choice);

/// Do its frames have ids?
IdChannel id_channel_of(const RendererChoice& choice);

/// Hands it the scene, which must outlive the result. Of one that zproof knows by name, triangles become the
/// labels that its ids are to stand for. Throws OracleError where it is absent or refuses, SceneError where
/// the labels are no scene's.
Renderer open(const RendererChoice& choice, const Scene& scene);

/// Throws as facts_of() does; its pictures throw what open() throws.
measure::Renderer measured_renderer(const RendererChoice& choice);

}  // namespace zproof
