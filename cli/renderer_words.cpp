#include "cli/renderer_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/usage_error.h"
#include "renderers/kept_input.h"
#include "renderers/registry.h"
#include "renderers/vulkan_words.h"

namespace zproof {
namespace {

constexpr std::string_view nobody = "none", sample_word = ":sample";

/// The oracles of a run that names none.
std::vector<std::string> default_oracles() { return {"povray"}; }

RendererChoice stored_frame(const std::string& file, const std::string& precision) {
    return {.who = StoredFrame{file}, .precision_word = precision};
}

/// "povray" of "povray:sample".
std::string name_in(const std::string& word) {
    return word.ends_with(sample_word) ? word.substr(0, word.size() - sample_word.size()) : word;
}

bool is_vulkan(const RendererChoice& choice) {
    const auto* built_in = std::get_if<BuiltIn>(&choice.who);
    return built_in != nullptr && built_in->name == vulkan_name;
}

RendererChoice oracle_named(const std::string& name) {
    if (names_vulkan(name) || std::ranges::count(renderer_names(), name) > 0) return renderer_from_word(name);
    throw UsageError{"oracle '" + name + "': expected one of " + std::string(nobody) + ", " +
                     joined(renderer_names()) + did_you_mean(name, renderer_names())};
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::count(names, name) > 0;
}

/// The names, each once, in their order; "none" is no name.
std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> once;
    const auto is_new = [&](const std::string& word) {
        return std::ranges::none_of(once, [&](const std::string& o) { return name_in(o) == name_in(word); });
    };
    for (const std::string& name : names)
        if (name != nobody && is_new(name)) once.push_back(name);
    return once;
}

std::vector<std::string> oracle_names(const RendererWords& words) {
    std::vector<std::string> names = words.oracles.value_or(default_oracles());
    names.insert(names.end(), words.required.begin(), words.required.end());
    return each_once(names);
}

void choose_device(RendererChoice& choice, const RendererWords& words) {
    if (auto* built_in = std::get_if<BuiltIn>(&choice.who); is_vulkan(choice))
        built_in->vulkan.device = words.device;
}

OracleChoice oracle_choice(const std::string& word, const RendererWords& words) {
    const bool required = contains(words.required, word) || contains(words.required, name_in(word));
    const bool asked = required || (words.oracles && contains(*words.oracles, word));
    OracleChoice choice{.renderer = oracle_named(name_in(word))};
    choose_device(choice.renderer, words);
    choice.renderer.time_limit = std::chrono::seconds{words.time_limit_s};
    if (word.ends_with(sample_word)) choice.pixels = OracleChoice::Pixels::sample;
    if (!asked) choice.pixels = OracleChoice::Pixels::sample_if_cheap;
    if (asked) choice.need = required ? OracleChoice::Need::required : OracleChoice::Need::named;
    return choice;
}

std::shared_ptr<KeptInput> kept_input(const RendererWords& words, const RendererChoice& choice) {
    if (words.keep_input.empty()) return nullptr;
    if (std::holds_alternative<Program>(choice.who)) return std::make_shared<KeptInput>(words.keep_input);
    throw UsageError{"--keep-input: only a renderer that is a program is handed files, found '" +
                     name_of(choice) + "'; expected a command with {scene} and {out} in it"};
}

/// Only frames that somebody else made need to be told how to read.
void refuse_convention_of_built_in(const RendererChoice& choice) {
    if (!std::holds_alternative<BuiltIn>(choice.who)) return;
    if (choice.convention.convention.empty() && choice.convention.channels.empty()) return;
    throw UsageError{"--convention and --channels are for frames of a program or a file; renderer '" +
                     name_of(choice) + "' needs none"};
}

/// Only Vulkan has devices to choose from.
void refuse_device_of_others(const RendererChoice& candidate, const RendererWords& words) {
    if (words.device.empty() || is_vulkan(candidate) ||
        std::ranges::any_of(oracle_names(words), names_vulkan))
        return;
    throw UsageError{"--device: is of the renderer vulkan, or of the oracle; found '" + name_of(candidate) +
                     "'"};
}

/// --convention and --channels, or the same of the reference.
void add_convention(CLI::App& app, const std::string& prefix, ConventionWords& words) {
    app.add_option(prefix + "convention", words.convention,
                   "how frames are to be read: a preset such as pytorch3d, KEY=VALUE,... or a JSON file")
        ->type_name("CONVENTION");
    app.add_option(prefix + "channels", words.channels, "their channels: id=NAME,depth=NAME")
        ->type_name("CHANNELS");
}

}  // namespace

void add_precision_options(CLI::App& app, RendererWords& words) {
    app.add_option("--precision", words.precision,
                   "what the renderer promises: a JSON file, or e.g. raster,subpixel_bits=4")
        ->type_name("PROMISE");
    add_time_limit(app, words);
    add_convention(app, "--", words.convention);
    add_device(app, words);
}

void add_time_limit(CLI::App& app, RendererWords& words) {
    app.add_option("--time-limit", words.time_limit_s,
                   "seconds for a picture of a renderer that is a program")
        ->check(CLI::Range(1, 86400))
        ->capture_default_str();
}

void add_device(CLI::App& app, RendererWords& words) {
    app.add_option("--device", words.device,
                   "part of the name of the device that vulkan asks (zproof doctor)")
        ->type_name("DEVICE");
}

void add_renderer_options(CLI::App& app, RendererWords& words) {
    app.add_option("--renderer", words.renderer,
                   "who is judged: zproof, embree, opengl, povray, vulkan, or 'CMD {scene} {camera} {width} "
                   "{height} {out}'")
        ->type_name("RENDERER")
        ->capture_default_str();
    add_precision_options(app, words);
    add_keep_input(app, words);
}

void add_keep_input(CLI::App& app, RendererWords& words) {
    app.add_option("--keep-input", words.keep_input,
                   "folder for the scenes and cameras that a renderer that is a program is handed")
        ->type_name("FOLDER");
}

void add_ids_option(CLI::App& app, RendererWords& words) {
    app.add_option(
           "--ids", words.ids,
           "what the ids of the frame that is judged stand for: triangle, none (depth alone), primitive, "
           "node, material, cryptomatte-object, cryptomatte-material, or a JSON file of labels")
        ->type_name("IDS")
        ->capture_default_str();
}

void add_stored_frame_options(CLI::App& app, RendererWords& words) {
    app.add_option("--candidate", words.candidate, "a stored frame (.exr) in the renderer's place");
    app.add_option("--reference", words.reference, "a stored frame (.exr) in Embree's place");
    add_reference_words(app, words);
}

void add_reference_words(CLI::App& app, RendererWords& words) {
    app.add_option("--reference-precision", words.reference_precision,
                   "what the renderer of a stored reference promises")
        ->type_name("PROMISE");
    add_convention(app, "--reference-", words.reference_convention);
}

void add_oracle_options(CLI::App& app, RendererWords& words) {
    app.add_option("--oracle", words.oracles,
                   "oracles beside Embree, each judged as well: povray,opengl; povray:sample: at some "
                   "pixels; or none")
        ->type_name("ORACLES")
        ->delimiter(',')
        ->allow_extra_args(false);  // the next word is a scene
    app.add_option("--require", words.required, "oracles without which nothing is proven")
        ->type_name("RENDERERS")
        ->delimiter(',')
        ->allow_extra_args(false);
}

void take_renderer(std::vector<std::string>& typed, RendererWords& words) {
    const auto is_renderer = [](const std::string& word) {
        return contains(renderer_names(), word) || names_vulkan(word) ||
               word.find("{out}") != std::string::npos;
    };
    for (auto word = std::ranges::find_if(typed, is_renderer); word != typed.end();
         word = std::ranges::find_if(typed, is_renderer)) {
        if (words.renderer != RendererWords{}.renderer)
            throw UsageError{"'" + words.renderer + "' and '" + *word + "' are two renderers; expected one"};
        words.renderer = *word;
        typed.erase(word);
    }
}

RendererChoice candidate_of(const RendererWords& words) {
    RendererChoice choice =
        words.candidate.empty() ? renderer_from_word(words.renderer) : stored_frame(words.candidate, "");
    choice.precision_word = words.precision;
    choice.ids = ids_from_word(words.ids);
    choice.convention = words.convention;
    refuse_convention_of_built_in(choice);
    refuse_device_of_others(choice, words);
    choose_device(choice, words);
    choice.time_limit = std::chrono::seconds{words.time_limit_s};
    choice.kept_input = kept_input(words, choice);
    return choice;
}

ChosenRenderers chosen_renderers(const RendererWords& words) {
    ChosenRenderers renderers{.candidate = candidate_of(words), .oracles = {}};
    if (!words.reference.empty()) {
        renderers.reference = stored_frame(words.reference, words.reference_precision);
        renderers.reference.convention = words.reference_convention;
    }
    for (const std::string& word : oracle_names(words))
        if (const std::string name = name_in(word);
            name != name_of(renderers.candidate) && name != name_of(renderers.reference))
            renderers.oracles.push_back(oracle_choice(word, words));
    return renderers;
}

}  // namespace zproof
