/// Options that several commands have in common.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "program/command_line/common_options.h"

namespace zproof {

inline constexpr const char* scene_words =
    "suite scene, random:KIND:SEED:NUMBER, model (.gltf, .glb, .obj, .ply), or view file (.json)";

/// As many as a command line may ask for.
inline constexpr std::uint64_t most_random_scenes = 100'000;

/// --seed, --kind. Returns them, in this order.
std::array<CLI::Option*, 2> add_random_choice(CLI::App& app, RandomChoice& random);

/// --models
void add_models(CLI::App& app, std::filesystem::path& models);
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
