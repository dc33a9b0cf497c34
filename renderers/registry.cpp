#include "renderers/registry.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "compare/labels/labelled_frame.h"
#include "frame/convention_text.h"
#include "frame/frame_error.h"
#include "frame/precision_text.h"
#include "oracle/convention/stored_frame.h"
#include "oracle/embree.h"
#include "oracle/external.h"
#include "oracle/opengl.h"
#include "oracle/oracle_error.h"
#include "oracle/povray.h"
#include "oracle/povray/budget.h"
#include "oracle/subprocess.h"
#include "oracle/vulkan.h"
#include "program/samples.h"
#include "program/usage_error.h"
#include "program/version.h"
#include "rasterizer/rasterizer.h"
#include "renderers/kept_input.h"

namespace zproof {

namespace {

/// What it does once it has met a scene.
struct Answers {
    std::function<Frame(const View&)> render;
    std::function<Picture(const View&, const Light&)> paint{};  ///< empty: has no colours of its own
    std::function<BegunSample(const View&, std::uint64_t seed)> begin_sample{};  ///< as Renderer's
    std::function<double(const View&, double most_s)> sample_price_s{};          ///< as Renderer's
    std::function<std::vector<std::string>(const View&)> channels{};             ///< as Renderer's
};

/// One that zproof knows by name. A new one is a row in `known`.
struct Known {
    const char* name;
    std::string (*absence)(const BuiltIn&);  ///< why it cannot be asked on this machine; empty: it can
    std::string (*version)(const BuiltIn&);
    Precision (*precision)(const BuiltIn&);
    Answers (*on)(const Scene& scene, const BuiltIn& one, std::chrono::seconds time_limit);
};

std::string never_absent(const BuiltIn&) { return ""; }

std::string rasterizer_version(const BuiltIn&) { return version_number(); }

Precision rasterizer_precision(const BuiltIn&) { return rasterizer::precision(); }

Answers rasterizer_on(const Scene& scene, const BuiltIn&, std::chrono::seconds) {
    return {[&scene](const View& view) { return rasterizer::render(scene, view); }};
}

std::string embree_version(const BuiltIn&) { return oracle::embree_version(); }

Precision embree_precision(const BuiltIn&) { return oracle::embree_precision(); }

Answers embree_on(const Scene& scene, const BuiltIn&, std::chrono::seconds) {
    const auto embree = std::make_shared<const oracle::Embree>(scene);
    return {[embree](const View& view) { return embree->trace(view); }};
}

/// OpenGL is asked only once, since that starts a driver.
std::string opengl_absence(const BuiltIn&) {
    static const std::string why = oracle::opengl_is_missing().value_or("");
    return why;
}

/// The driver is opened once, when it is first needed: it takes longer to start than a picture to draw.
const oracle::OpenGlDriver& opengl_driver() {
    static const oracle::OpenGlDriver driver;
    return driver;
}

std::string opengl_version(const BuiltIn&) { return opengl_driver().version(); }

Precision opengl_precision(const BuiltIn&) { return opengl_driver().precision(); }

Answers opengl_on(const Scene& scene, const BuiltIn&, std::chrono::seconds) {
    const auto opengl = std::make_shared<const oracle::OpenGl>(scene, opengl_driver());
    return {[opengl](const View& view) { return opengl->render(view); }};
}

/// A device with these settings is opened once, when it is first needed. It is never closed: at the program's
/// end its library has taken itself apart before us (SwiftShader's crashes then).
const oracle::VulkanDriver& vulkan_driver(const BuiltIn& vulkan) {
    static std::mutex one_thread;
    static auto& drivers = *new std::map<oracle::VulkanSettings, oracle::VulkanDriver>;
    const std::scoped_lock lock(one_thread);
    const auto found = drivers.find(vulkan.vulkan);
    return found != drivers.end() ? found->second
                                  : drivers.try_emplace(vulkan.vulkan, vulkan.vulkan).first->second;
}

std::string vulkan_absence(const BuiltIn& vulkan) {
    try {
        vulkan_driver(vulkan);
        return "";
    } catch (const OracleError& e) {
        return e.what();
    }
}

std::string vulkan_version(const BuiltIn& vulkan) { return vulkan_driver(vulkan).version(); }

Precision vulkan_precision(const BuiltIn& vulkan) { return vulkan_driver(vulkan).precision(); }

Answers vulkan_on(const Scene& scene, const BuiltIn& one, std::chrono::seconds) {
    const auto vulkan = std::make_shared<const oracle::Vulkan>(scene, vulkan_driver(one));
    return {[vulkan](const View& view) { return vulkan->render(view); }};
}

/// Does a shell find it: a file, a program on PATH, or a word of its own such as `cd`?
bool can_be_started(const std::string& name) {
    if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0;
    return oracle::run({.arguments = oracle::shell_line("command -v " + name)}).succeeded();
}

std::string povray_version(const BuiltIn&) { return oracle::povray_version().value_or(""); }

Precision povray_precision(const BuiltIn&) { return oracle::povray_precision(); }

std::string povray_absence(const BuiltIn&) {
    static const bool is_there = can_be_started("povray");
    return is_there ? "" : "not installed; on Debian: apt-get install povray";
}

Answers povray_on(const Scene& scene, const BuiltIn&, std::chrono::seconds time_limit) {
    const auto povray =
        std::make_shared<const oracle::PovRay>(scene, oracle::PovRayOptions{.time_limit = time_limit});
    return {[povray](const View& view) { return povray->render(view); },
            [povray](const View& view, const Light& light) { return povray->picture(view, light); },
            [povray, &scene](const View& view, std::uint64_t seed) {
                const auto [pixels, fewer_because, seconds] = oracle::affordable_pixels(scene, view, seed);
                return BegunSample{pixels, fewer_because, povray->begin(view_of(pixels, view), 1)};
            },
            [&scene](const View& view, double most_s) {
                const double start_s = oracle::povray_start_s;
                return start_s > most_s ? start_s
                                        : start_s + oracle::affordable_pixels(scene, view, 0).seconds;
            }};
}

constexpr std::array known{
    Known{"zproof", never_absent, rasterizer_version, rasterizer_precision, rasterizer_on},
    Known{"embree", never_absent, embree_version, embree_precision, embree_on},
    Known{"opengl", opengl_absence, opengl_version, opengl_precision, opengl_on},
    Known{"povray", povray_absence, povray_version, povray_precision, povray_on},
    Known{"vulkan", vulkan_absence, vulkan_version, vulkan_precision, vulkan_on},
};

const Known& known_as(const BuiltIn& built_in) {
    return *std::ranges::find(known, built_in.name, [](const Known& k) { return std::string{k.name}; });
}

Precision own_promise(const RendererChoice& choice) {
    if (const auto* built_in = std::get_if<BuiltIn>(&choice.who))
        return known_as(*built_in).precision(*built_in);
    return RasterPrecision{};
}

Answers stored(const RendererChoice& choice) {
    Answers answers;
    answers.render = [choice](const View& view) {
        const RendererChoice one = at_sample(choice, view.sample);
        const Convention convention = declared_convention(one);
        try {
            return oracle::read_stored_frame(std::get<StoredFrame>(one.who).file, convention, view,
                                             id_channel_of(one), one.time_limit);
        } catch (const FrameError& e) {
            throw OracleError{e.what()};  // the view cannot be judged; the others can
        }
    };
    answers.channels = [choice](const View& view) {
        const RendererChoice one = at_sample(choice, view.sample);
        return oracle::stored_frame_channels(std::get<StoredFrame>(one.who).file, one.time_limit);
    };
    return answers;
}

Answers program(const RendererChoice& choice, const Scene& scene) {
    const auto external = std::make_shared<const oracle::External>(
        scene, std::get<Program>(choice.who).command, choice.time_limit, declared_convention(choice),
        id_channel_of(choice));
    Answers answers;
    answers.render = [external](const View& view) { return external->render(view); };
    answers.channels = [external](const View&) { return external->channels(); };
    if (!choice.kept_input) return answers;
    const std::string name = choice.kept_input->keep(scene);
    answers.render = [external, name, kept_input = choice.kept_input](const View& view) {
        kept_input->keep(name, view);
        return external->render(view);
    };
    return answers;
}

Answers answers_on(const RendererChoice& choice, const Scene& scene) {
    if (const auto* built_in = std::get_if<BuiltIn>(&choice.who))
        return known_as(*built_in).on(scene, *built_in, choice.time_limit);
    if (std::holds_alternative<StoredFrame>(choice.who)) return stored(choice);
    return program(choice, scene);
}

std::shared_ptr<const TriangleLabels> labels_of(const RendererChoice& choice, const Scene& scene) {
    if (choice.ids == RendererChoice{}.ids) return nullptr;
    TriangleLabels labels = label_triangles(choice.ids, scene);
    labels.is_far_background = labels.are_absent && declared_convention(choice).far_is_background;
    return std::make_shared<const TriangleLabels>(std::move(labels));
}

/// What `read` makes of a word of the command line; a fault in it is one of usage.
template <class Read>
auto typed(const Read& read) {
    try {
        return read();
    } catch (const FrameError& e) {
        throw UsageError{e.what()};
    }
}

/// The word after --precision, else its own; what its convention costs is not in it.
Precision promise_of(const RendererChoice& choice) {
    const std::string& word = choice.precision_word;
    if (word.empty()) return own_promise(choice);
    return is_promise_in_words(word) ? typed([&] { return precision_from_word(word); })
                                     : precision_from_word(word);
}

/// What a command line begins with; empty where that is more than a name, so that only a shell knows.
std::string first_name_in(const std::string& command) {
    const std::string word = command.substr(0, command.find(' '));
    const auto is_plain = [](char c) {
        return std::isalnum(std::uint8_t(c)) != 0 || std::strchr("./_+-", c);
    };
    return std::ranges::all_of(word, is_plain) ? word : "";
}

/// Those that zproof knows by name give triangles.
void give_labels(Answers& answers, const std::shared_ptr<const TriangleLabels>& labels) {
    answers.render = [render = answers.render, labels](const View& view) {
        return with_labels(render(view), *labels);
    };
}

}  // namespace

std::vector<std::string> renderer_names() {
    std::vector<std::string> names;
    for (const Known& one : known) names.emplace_back(one.name);
    return names;
}

std::string absence_of(const RendererChoice& choice) {
    const auto* built_in = std::get_if<BuiltIn>(&choice.who);
    return built_in == nullptr ? "" : known_as(*built_in).absence(*built_in);
}

void require_program(const RendererChoice& choice) {
    const auto* program = std::get_if<Program>(&choice.who);
    const std::string name = program == nullptr ? "" : first_name_in(program->command);
    if (name.empty() || can_be_started(name)) return;
    throw UsageError{"renderer '" + program->command + "': expected a program that can be started, found '" +
                     name + "', which is not there or not executable"};
}

Precision declared_precision(const RendererChoice& choice) {
    Precision precision = promise_of(choice);
    const double depth_step = declared_convention(choice).depth_step();
    std::visit([&](auto& p) { p.depth_step = std::max(p.depth_step, depth_step); }, precision);
    return precision;
}

Projections declared_projections(const RendererChoice& choice) {
    const std::string& word = choice.precision_word;
    if (word.empty()) return {};
    return is_promise_in_words(word) ? typed([&] { return projections_from_word(word); })
                                     : projections_from_word(word);
}

Convention declared_convention(const RendererChoice& choice) {
    const auto& [convention, channels] = choice.convention;
    const auto read = [&] { return convention_from_words(convention, channels); };
    return is_convention_file(convention) ? read() : typed(read);
}

RendererFacts facts_of(const RendererChoice& choice) {
    const auto* built_in = std::get_if<BuiltIn>(&choice.who);
    require_program(choice);  // refused before anything is rendered, and so is a convention
    declared_convention(choice);
    return {.name = name_of(choice),
            .version = built_in == nullptr ? "" : known_as(*built_in).version(*built_in),
            .precision = precision_to_json(declared_precision(choice)),
            .ids = choice.ids};
}

IdChannel id_channel_of(const RendererChoice& choice) {
    return choice.ids == "none" ? IdChannel::absent : IdChannel::present;
}

Renderer open(const RendererChoice& choice, const Scene& scene) {
    if (const std::string absent = absence_of(choice); !absent.empty())
        throw OracleError{name_of(choice) + ": " + absent};
    Answers answers = answers_on(choice, scene);
    std::shared_ptr<const TriangleLabels> labels = labels_of(choice, scene);
    if (labels && std::holds_alternative<BuiltIn>(choice.who)) give_labels(answers, labels);
    return {.name = name_of(choice),
            .precision = declared_precision(choice),
            .projections = declared_projections(choice),
            .render = std::move(answers.render),
            .paint = std::move(answers.paint),
            .begin_sample = std::move(answers.begin_sample),
            .sample_price_s = std::move(answers.sample_price_s),
            .channels = std::move(answers.channels),
            .labels = std::move(labels),
            .convention = declared_convention(choice)};
}

measure::Renderer measured_renderer(const RendererChoice& choice) {
    require_program(choice);
    return {
        .name = name_of(choice),
        .render = [choice](const Scene& scene, const View& view) { return open(choice, scene).render(view); },
        .declared = declared_precision(choice)};
}

}  // namespace zproof
