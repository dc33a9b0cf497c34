#include "tests/frozen/subjects.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "oracle/oracle_error.h"
#include "program/scene_selection.h"
#include "rasterizer/rasterizer.h"
#include "renderers/registry.h"
#include "scenes/scene_error.h"
#include "selftest/test_scene.h"
#include "tests/frozen/interior_views.h"
#include "tests/frozen/planted.h"
#include "tests/frozen/random_scenes.h"
#include "tests/frozen/true_depth.h"

namespace zproof::frozen {
namespace {

using Take = std::function<void(Subject)>;

constexpr Resolution size_of_views{.width = 480, .height = 270};

/// A view, and the name of its subject.
struct NamedView {
    std::string name;
    std::shared_ptr<const Scene> scene;
    View view;
};

/// A scene that is known of, with views beside its own.
struct Source {
    SceneSource scene;
    std::vector<View> more_views{};
};
using Sources = std::vector<Source>;

/// Is it the wanted subject, or the scene of it?
bool concerns(const Wanted& wanted, const std::string& name) {
    return wanted.name.empty() || wanted.name == name || wanted.name.starts_with(name + "/");
}

/// The scene's views that are wanted; none of a scene that cannot be read or has no triangles.
std::vector<NamedView> wanted_views(const Wanted& wanted, const Source& source) {
    std::vector<NamedView> wanted_ones;
    const std::string& name = source.scene.name;
    if (!concerns(wanted, name)) return {};
    try {
        Loaded loaded = load(source.scene, size_of_views);
        if (loaded.scene.triangles.empty()) return {};
        const auto scene = std::make_shared<const Scene>(std::move(loaded.scene));
        for (const std::vector<View>& views : {loaded.views, source.more_views})
            for (const View& view : views)
                if (concerns(wanted, name + "/" + view.name))
                    wanted_ones.push_back({name + "/" + view.name, scene, view});
    } catch (const SceneError&) {
    }
    return wanted_ones;
}

/// Two renderers that zproof knows by name.
struct Pair {
    const char *candidate, *reference;
    std::size_t most_triangles = std::size_t(-1);
};

RendererChoice renderer_named(const char* name) { return {.who = BuiltIn{name}, .precision_word = {}}; }

Subject subject_of(const std::string& group, const std::string& name, Case c) {
    Subject subject{group, name, {}};
    subject.cases.push_back(std::move(c));
    return subject;
}

void add_rendered(const Wanted& wanted, const NamedView& seen, const Renderer& candidate,
                  const Renderer& reference, const Take& take) {
    try {
        take(subject_of(wanted.group, seen.name,
                        {seen.scene, seen.view, candidate.render(seen.view), reference.render(seen.view),
                         candidate.precision, reference.precision}));
    } catch (const OracleError&) {  // the view is beyond a renderer's means
    }
}

void add_scene(const Wanted& wanted, const std::vector<NamedView>& views, const Pair& pair,
               const Take& take) {
    try {
        const Scene& scene = *views.front().scene;
        const Renderer candidate = open(renderer_named(pair.candidate), scene);
        const Renderer reference = open(renderer_named(pair.reference), scene);
        for (const NamedView& seen : views) add_rendered(wanted, seen, candidate, reference, take);
    } catch (const OracleError&) {  // the scene is, or the renderer is absent
    }
}

void each_rendered(const Wanted& wanted, const Sources& sources, const Pair& pair, const Take& take) {
    for (const Source& source : sources) {
        const std::vector<NamedView> views = wanted_views(wanted, source);
        if (!views.empty() && views.front().scene->triangles.size() <= pair.most_triangles)
            add_scene(wanted, views, pair, take);
    }
}

Sources suite_scenes() {
    Sources sources;
    for (SceneSource& scene : select_scenes({"suite"})) sources.push_back({std::move(scene)});
    return sources;
}

/// Named by their files' places in the folder.
Sources models() {
    const std::filesystem::path folder = ZPROOF_MODELS;
    if (!std::filesystem::exists(folder)) return {};
    std::map<std::string, std::vector<View>> inside = interior_views(folder, size_of_views);
    Sources sources;
    for (SceneSource& scene : select_scenes({folder.string()})) {
        scene.name = std::filesystem::path(scene.origin).lexically_relative(folder).generic_string();
        std::vector<View> more_views = inside[scene.name];
        sources.push_back({std::move(scene), std::move(more_views)});
    }
    return sources;
}

void suite(const Wanted& wanted, const Take& take) {
    each_rendered(wanted, suite_scenes(), {"zproof", "embree"}, take);
}

void opengl(const Wanted& wanted, const Take& take) {
    each_rendered(wanted, suite_scenes(), {"opengl", "embree"}, take);
}

void povray(const Wanted& wanted, const Take& take) {
    each_rendered(wanted, suite_scenes(), {"povray", "embree", 100'000}, take);
}

void of_models(const Wanted& wanted, const Take& take) {
    each_rendered(wanted, models(), {"zproof", "embree"}, take);
}

/// Two frames of zproof's own of one view.
struct TwoFrames {
    Frame candidate, reference;
};
/// Each view has a seed of its own, and may use the next one as well.
using MakeFrames = TwoFrames (*)(const NamedView& seen, std::uint32_t seed);

void each_of_our_own(const Wanted& wanted, const MakeFrames& make, const Take& take) {
    std::uint32_t seed = 0;
    for (const Source& source : suite_scenes()) {
        seed += 1000;
        if (!concerns(wanted, source.scene.name)) continue;
        std::uint32_t of_view = seed;
        for (const NamedView& seen : wanted_views({wanted.group}, source)) {
            of_view += 2;
            if (!concerns(wanted, seen.name)) continue;
            TwoFrames frames = make(seen, of_view);
            const Precision precision = rasterizer::precision();
            take(subject_of(wanted.group, seen.name,
                            {seen.scene, seen.view, std::move(frames.candidate), std::move(frames.reference),
                             precision, precision}));
        }
    }
}

TwoFrames planted_frames(const NamedView& seen, std::uint32_t seed) {
    const Frame good = rasterizer::render(*seen.scene, seen.view);
    return {with_planted_answers(*seen.scene, seen.view, good, seed),
            with_planted_answers(*seen.scene, seen.view, good, seed + 1)};
}

void planted(const Wanted& wanted, const Take& take) { each_of_our_own(wanted, planted_frames, take); }

/// The view with its image moved by at most 2^-11 to 2^-7 px.
View moved(View view, std::uint32_t seed) {
    RandomNumbers numbers(seed);
    Window& window = view.camera.window;
    const double size = power_of_two(-numbers.below(5) - 7);
    const double right = size * numbers.between(-1, 1) * (window.right - window.left) / view.width;
    const double up = size * numbers.between(-1, 1) * (window.top - window.bottom) / view.height;
    window = {window.left + right, window.right + right, window.bottom + up, window.top + up};
    return view;
}

TwoFrames moved_frames(const NamedView& seen, std::uint32_t seed) {
    TwoFrames frames{rasterizer::render(*seen.scene, moved(seen.view, seed)),
                     rasterizer::render(*seen.scene, seen.view)};
    set_true_depths(*seen.scene, seen.view, frames.candidate);
    return frames;
}

void moved_slightly(const Wanted& wanted, const Take& take) { each_of_our_own(wanted, moved_frames, take); }

/// Every sort of promise that a renderer can make.
Precision random_precision(RandomNumbers& numbers) {
    const std::array<Precision, 8> promises{rasterizer::precision(),
                                            RasterPrecision{},
                                            RasterPrecision{.origin = Origin::eye,
                                                            .clipping = Clipping::view_volume,
                                                            .depth_buffer = DepthBuffer::reversed_z,
                                                            .depth_interpolation = DepthInterpolation::plane,
                                                            .depth_roundings = 1},
                                            RasterPrecision{.subpixel_bits = 4, .snap = Snap::truncate},
                                            RayPrecision{},
                                            RayPrecision{.arithmetic = Arithmetic::float64},
                                            PlaneRayPrecision{},
                                            PlaneRayPrecision{.aim_offset_px = 0x1p-28,
                                                              .depth_relative = 0x1.0001p-23,
                                                              .depth_of_range = 0x1.0001p-29,
                                                              .clip_relative = 0x1p-23,
                                                              .clip_of_reach = 0x1p-41}};
    return numbers.one_of(promises);
}

Case random_case(std::uint32_t seed) {
    const RandomScene of = random_scene(seed);
    RandomNumbers numbers(seed + 1'000'000);
    Frame candidate = random_answers(of, numbers), reference = random_answers(of, numbers);
    const Precision ours = random_precision(numbers), theirs = random_precision(numbers);
    return {std::make_shared<const Scene>(of.scene),
            of.view,
            std::move(candidate),
            std::move(reference),
            ours,
            theirs};
}

void random(const Wanted& wanted, const Take& take) {
    constexpr std::uint32_t subjects = 20, cases = 100;
    for (std::uint32_t i = 0; i < subjects; ++i) {
        Subject subject{wanted.group, "from_" + std::to_string(i * cases), {}};
        if (!concerns(wanted, subject.name)) continue;
        for (std::uint32_t k = 0; k < cases; ++k) subject.cases.push_back(random_case(i * cases + k));
        take(std::move(subject));
    }
}

/// The scene of the selftest with its two frames.
struct FaultGround {
    std::shared_ptr<const Scene> scene;
    View view;
    Frame good, reference;

    selftest::Fixture fixture() const {
        return {*scene,
                view,
                good,
                reference,
                rasterizer::precision(),
                declared_precision(renderer_named("embree"))};
    }
};

FaultGround fault_ground() {
    Loaded loaded = load(select_scene(selftest::fixture_scene), size_of_views);
    FaultGround ground{std::make_shared<const Scene>(std::move(loaded.scene)), loaded.views.front(), {}, {}};
    ground.good = rasterizer::render(*ground.scene, ground.view);
    ground.reference = open(renderer_named("embree"), *ground.scene).render(ground.view);
    return ground;
}

Case case_of(const selftest::Fault& fault, const FaultGround& ground) {
    const selftest::Fixture fixture = ground.fixture();
    const bool of_reference = fault.target == selftest::Target::reference;
    const bool of_renderer = fault.precision_source == selftest::PrecisionSource::of_renderer;
    Frame faulty = fault.inject(fixture);
    return {ground.scene,
            ground.view,
            of_reference ? ground.good : faulty,
            of_reference ? faulty : ground.reference,
            of_renderer ? fixture.precision : fixture.reference_precision,
            fixture.reference_precision};
}

void faults(const Wanted& wanted, const Take& take) {
    const FaultGround ground = fault_ground();
    for (const selftest::Fault& fault : selftest::catalogue()) {
        if (concerns(wanted, fault.name)) take(subject_of(wanted.group, fault.name, case_of(fault, ground)));
    }
}

struct Group {
    std::string_view name;
    void (*each)(const Wanted&, const Take&);
};

constexpr std::array all_groups{Group{"planted", planted}, Group{"moved", moved_slightly},
                                Group{"random", random},   Group{"suite", suite},
                                Group{"selftest", faults}, Group{"opengl", opengl},
                                Group{"povray", povray},   Group{"models", of_models}};

}  // namespace

std::span<const std::string_view> groups() {
    static const auto names = [] {
        std::array<std::string_view, all_groups.size()> array;
        std::ranges::transform(all_groups, array.begin(), &Group::name);
        return array;
    }();
    return names;
}

void each_subject(const Wanted& wanted, const Take& take) {
    const auto group = std::ranges::find(all_groups, wanted.group, &Group::name);
    if (group == all_groups.end()) throw std::invalid_argument("no such group: " + wanted.group);
    group->each(wanted, take);
}

}  // namespace zproof::frozen
