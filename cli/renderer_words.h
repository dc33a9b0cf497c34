/// The options that choose renderers: --renderer, --precision, --oracle and so on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderers/choice.h"

namespace CLI {
class App;
}

namespace zproof {

/// The words about renderers as typed.
struct RendererWords {
    std::string renderer = "zproof", precision;             ///< of the candidate
    std::string candidate, reference, reference_precision;  ///< stored frames
    ConventionWords convention, reference_convention;       ///< how their frames are to be read
    std::optional<std::vector<std::string>> oracles;        ///< nothing: the usual ones
    std::vector<std::string> required;
    std::string ids = "triangle";  ///< of the candidate
    std::string filter;            ///< of textures; empty: none
    std::string keep_input;        ///< folder for what a program is handed; empty: it is not kept
    std::string device;            ///< of Vulkan; empty: the first
    int time_limit_s = 600;
};

void add_renderer_options(CLI::App& app, RendererWords& words);   ///< --renderer, those of the next three
void add_precision_options(CLI::App& app, RendererWords& words);  ///< --precision, --time-limit, --convention
void add_ids_option(CLI::App& app, RendererWords& words);         ///< --ids
void add_keep_input(CLI::App& app, RendererWords& words);         ///< --keep-input
void add_time_limit(CLI::App& app, RendererWords& words);         ///< --time-limit
void add_device(CLI::App& app, RendererWords& words);             ///< --device
void add_stored_frame_options(CLI::App& app, RendererWords& words);  ///< --candidate, --reference
/// --reference-precision, --reference-convention, --reference-channels
void add_reference_words(CLI::App& app, RendererWords& words);
void add_oracle_options(CLI::App& app, RendererWords& words);  ///< --oracle, --require

/// Takes a renderer from among the words after a command, where one stands there: `zproof fit embree room` is
/// `zproof fit room --renderer embree`. Throws UsageError where there are two.
void take_renderer(std::vector<std::string>& typed, RendererWords& words);

/// The renderer that the words call the candidate. Throws UsageError.
RendererChoice candidate_of(const RendererWords& words);

/// All renderers of the run. Throws UsageError.
ChosenRenderers chosen_renderers(const RendererWords& words);

}  // namespace zproof
