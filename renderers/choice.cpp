#include "renderers/choice.h"

#include <algorithm>

#include "frame/input_file.h"
#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/shell_line.h"
#include "program/usage_error.h"
#include "renderers/registry.h"
#include "renderers/vulkan_words.h"
#include "scenes/triangle_labels.h"

namespace zproof {
namespace {

std::string known_names() { return joined(renderer_names()); }

std::string option_of(const BuiltIn& built_in) {
    const std::string& device = built_in.vulkan.device;
    return " --renderer " + built_in.name + words_of(built_in.vulkan) +
           (device.empty() ? "" : " --device " + shell_quoted(device));
}

std::string option_of(const Program& program) { return " --renderer " + shell_quoted(program.command); }

std::string option_of(const StoredFrame& stored) {
    return " --candidate " + shell_quoted(stored.file.string());
}

}  // namespace

RendererChoice renderer_from_word(const std::string& word) {
    if (names_vulkan(word))
        return {.who = BuiltIn{std::string(vulkan_name),
                               vulkan_settings_from_words(word.substr(vulkan_name.size()))},
                .precision_word = {}};
    if (std::ranges::count(renderer_names(), word) > 0) return {.who = BuiltIn{word}, .precision_word = {}};
    if (word.find("{out}") != std::string::npos) return {.who = Program{word}, .precision_word = {}};
    throw UsageError{"renderer '" + word + "': expected one of " + known_names() +
                     ", or a command that writes its frame to {out} (docs/renderer-contract.md)" +
                     did_you_mean(word, renderer_names())};
}

std::string ids_from_word(const std::string& word) {
    const std::string fault = fault_of_label_word(word);
    if (fault.empty()) return word;
    throw UsageError{"--ids " + word + ": " + fault};
}

bool are_the_usual(const ChosenRenderers& renderers) {
    const ChosenRenderers usual{.oracles = {}};
    const auto same = [](const RendererChoice& a, const RendererChoice& b) {
        return name_of(a) == name_of(b) && a.precision_word == b.precision_word && a.ids == b.ids;
    };
    return same(renderers.candidate, usual.candidate) && same(renderers.reference, usual.reference);
}

std::string name_of(const RendererChoice& choice) {
    if (const auto* built_in = std::get_if<BuiltIn>(&choice.who))
        return built_in->name + words_of(built_in->vulkan);
    if (const auto* program = std::get_if<Program>(&choice.who)) return program->command;
    return std::get<StoredFrame>(choice.who).file.string();
}

std::string options_for(const RendererChoice& choice) {
    std::string options = std::visit([](const auto& who) { return option_of(who); }, choice.who);
    if (!choice.precision_word.empty()) options += " --precision " + shell_quoted(choice.precision_word);
    if (choice.ids != RendererChoice{}.ids) options += " --ids " + shell_quoted(choice.ids);
    const auto& [convention, channels] = choice.convention;
    if (!convention.empty()) options += " --convention " + shell_quoted(convention);
    if (!channels.empty()) options += " --channels " + shell_quoted(channels);
    return options;
}

namespace {

constexpr std::string_view index_word = "{sample}";

void fill_in(std::string& text, int index) {
    for (std::size_t at; (at = text.find(index_word)) != text.npos;)
        text.replace(at, index_word.size(), std::to_string(index));
}

}  // namespace

RendererChoice at_sample(RendererChoice choice, const Sample& sample) {
    auto* stored = std::get_if<StoredFrame>(&choice.who);
    if (stored == nullptr) return choice;
    std::string file = stored->file.string();
    fill_in(file, sample.index);
    stored->file = file;
    fill_in(choice.convention.channels, sample.index);
    return choice;
}

bool has_frame_for_each_sample(const RendererChoice& choice) {
    const auto* stored = std::get_if<StoredFrame>(&choice.who);
    return stored == nullptr || stored->file.string().find(index_word) != std::string::npos ||
           choice.convention.channels.find(index_word) != std::string::npos;
}

}  // namespace zproof
