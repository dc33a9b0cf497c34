/// Options that several commands have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/arguments.h"

namespace zproof {

inline constexpr const char* scene_words =
    "suite scene, random:KIND:SEED:NUMBER, model (.gltf, .glb, .obj, .ply), or view file (.json)";

/// As many as a command line may ask for.
inline constexpr std::uint64_t most_random_scenes = 100'000;

/// Binds a word from a fixed list, which must outlive the app; the help shows the list, an unknown word is a
/// usage error.
template <class T>
CLI::Option* add_choice(CLI::App& app, const std::string& option, T& value,
                        const std::map<std::string, T>& choices) {
    std::vector<std::string> words;
    words.reserve(choices.size());
    for (const auto& [word, meaning] : choices) words.push_back(word);
    return app
        .add_option_function<std::string>(option, [&](const std::string& word) { value = choices.at(word); })
        ->check(CLI::IsMember(words))
        ->default_str("auto");
}

/// --seed, --kind. Returns them, in this order.
std::array<CLI::Option*, 2> add_random_choice(CLI::App& app, RandomChoice& random);

/// --models
void add_models(CLI::App& app, std::filesystem::path& models);
/// -j, --color, -q and -o: of every command, and stated here alone. `made`: what -o names, where it is not
/// what is printed.
void add_common(CLI::App& app, CommonArguments& common, const std::string& made = "");
void add_progress(CLI::App& app, CommonArguments& common);  ///< --progress
/// --isa; holds for the process as soon as it is read.
void add_isa(CLI::App& app);
void add_render_settings(CLI::App& app, RenderSettings& settings);  ///< --width, --height, --isa
void add_samples(CLI::App& app, RenderSettings& settings);          ///< --sample
void add_report(CLI::App& app, ReportArguments& report);  ///< the common ones, --report, --progress, --times
void add_evidence(CLI::App& app, ReportArguments& report);  ///< --evidence, --pictures
void add_gate(CLI::App& app, GateArguments& gate);          ///< --waivers, --strict, --now
void add_waiver_file(CLI::App& app, GateArguments& gate);   ///< --waivers, --now
/// --reference-cache, --reference-cache-size
void add_reference_cache(CLI::App& app, oracle::ReferenceCacheChoice& choice);
void add_settings_choice(CLI::App& app, SettingsChoice& settings);  ///< --config, --profile

}  // namespace zproof
