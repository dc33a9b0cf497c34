#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "cli/command_line/tree.h"
#include "cli/commands.h"
#include "frame/input_file.h"
#include "frame/joined.h"
#include "math/processor.h"
#include "program/companion.h"
#include "program/settings/apply.h"
#include "program/usage_error.h"
#include "program/version.h"
#include "renderers/registry.h"
#include "renderers/vulkan_words.h"
#include "reports/wording.h"

namespace zproof {
namespace {

const char* of_process(const std::string& name) { return std::getenv(name.c_str()); }

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

void print_row(const std::string& name, const std::string& value) {
    std::cout << "  " << padded(name, 14) << one_line(value) << "\n";
}

std::string usable_instructions() {
    return joined(instruction_sets(), ", ", [](InstructionSet set) { return name_of(set); }) + " (" +
           std::string(name_of(widest_allowed())) + " is used)";
}

void print_machine() {
    std::cout << "zproof " << version_number() << "\n";
    print_row("commit", commit());
    print_row("compiler", compiler_name());
    print_row("instructions", usable_instructions());
    print_row("processors", std::to_string(available_threads()));
}

void print_renderers() {
    std::cout << "renderers\n";
    for (const std::string& name : renderer_names()) {
        const RendererChoice choice = renderer_from_word(name);
        const std::string absent = absence_of(choice);
        const std::string version = absent.empty() ? facts_of(choice).version : "";
        print_row(name, !absent.empty() ? "absent: " + absent : version.empty() ? "built in" : version);
    }
}

void print_vulkan_devices() {
    if (!absence_of(renderer_from_word(std::string(vulkan_name))).empty()) return;
    std::cout << "devices of vulkan\n";
    for (const oracle::VulkanDevice& device : oracle::vulkan_devices())
        std::cout << "  " << one_line(device.version) << "\n      " << promise_in_words(device) << "\n";
}

void print_setting(const Setting& setting, const SettingValues& effective, const CLI::Option* option) {
    const auto said = std::ranges::find(effective, setting.name, &SettingValue::name);
    std::string value = said != effective.end() ? joined(said->words, " ") : option->get_default_str();
    if (value.empty() && setting.kind == Setting::Kind::flag) value = "false";
    print_row(setting.name,
              padded(value.empty() ? "-" : value, 24) + (said != effective.end() ? said->origin : "default"));
}

/// The first needed renderer or file that is missing; no run can end well without it.
std::string missing_among(const ChosenRenderers& renderers, const std::filesystem::path& waivers) {
    const auto absent = [](const RendererChoice& choice) {
        const std::string why = absence_of(choice);
        return why.empty() ? "" : name_of(choice) + ": " + why;
    };
    std::string missing = absent(renderers.reference);
    if (missing.empty()) missing = absent(renderers.candidate);
    for (const OracleChoice& oracle : renderers.oracles)
        if (missing.empty() && oracle.need != OracleChoice::Need::welcome) missing = absent(oracle.renderer);
    if (missing.empty() && !waivers.empty())
        if (const std::string fault = fault_of_input(waivers); !fault.empty())
            missing = "waivers: " + waivers.string() + ": " + fault;
    return missing;
}

/// Programs are a shell's affair: only asking for a picture shows whether they are there.
std::vector<std::string> programs_among(const ChosenRenderers& renderers) {
    std::vector<std::string> programs;
    const auto add = [&](const RendererChoice& choice) {
        if (const auto* program = std::get_if<Program>(&choice.who)) programs.push_back(program->command);
    };
    add(renderers.candidate);
    add(renderers.reference);
    for (const OracleChoice& oracle : renderers.oracles) add(oracle.renderer);
    return programs;
}

void print_programs() {
    std::cout << "programs\n";
    for (const Companion& companion : companions()) {
        const auto program = program_of(companion);
        print_row("zproof-" + std::string{companion.command}, program ? program->string() : "absent");
    }
}

void print_file(const SettingsChoice& choice) {
    const auto file = find_settings_file(choice, of_process);
    const std::string profile = chosen_profile(choice, file, of_process);
    std::cout << "settings of zproof run\n";
    print_row("file", file ? file->file.string() : "none");
    print_row("profile", profile.empty() ? "none" : profile);
}

void print_state(const SettingsChoice& choice, const SettingValues& effective, const CLI::App& run) {
    print_machine();
    print_renderers();
    print_vulkan_devices();
    print_programs();
    print_file(choice);
    for (const Setting& setting : known_settings())
        print_setting(setting, effective, run.get_option(option_name(setting.name)));
}

}  // namespace

ExitCode execute(const DoctorArguments& arguments) {
    CommandTree tree;
    CLI::App& run = *tree.root().get_subcommand("run");
    const SettingValues effective = settings_here(arguments.settings, of_process);
    give(effective, run);
    const ChosenRenderers renderers = chosen_renderers(tree.words().renderers);
    const bool is_quiet = arguments.common.is_quiet();
    if (!is_quiet) print_state(arguments.settings, effective, run);
    if (const std::string missing = missing_among(renderers, tree.words().run.report.gate.waivers);
        !missing.empty()) {
        std::cout << "missing: " << one_line(missing) << "\n";
        return ExitCode::cannot_judge;
    }
    const std::vector<std::string> programs = programs_among(renderers);
    for (const std::string& program : is_quiet ? std::vector<std::string>{} : programs)
        std::cout << "not tried: " << one_line(program) << " (zproof contract-check asks it for pictures)\n";
    std::cout << (programs.empty() ? "everything" : "everything else")
              << " that these settings need is here\n";
    return ExitCode::proven;
}

}  // namespace zproof
