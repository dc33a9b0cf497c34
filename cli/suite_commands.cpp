#include <algorithm>
#include <iostream>
#include <iterator>

#include "cli/commands.h"
#include "program/nearest_word.h"
#include "program/written_scenes.h"
#include "scenes/random_scenes.h"
#include "scenes/scene_error.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

std::vector<std::string> names_of(const std::vector<SuiteEntry>& entries) {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : entries) names.push_back(entry.name);
    return names;
}

/// With those of thorough runs.
std::vector<std::string> all_names() {
    std::vector<std::string> names = names_of(suite_manifest());
    std::ranges::move(names_of(thorough_manifest()), std::back_inserter(names));
    return names;
}

void require_in_the_suite(const std::vector<std::string>& requested) {
    const std::vector<std::string> suite = all_names();
    for (const std::string& name : requested)
        if (std::ranges::find(suite, name) == suite.end())
            throw SceneError{name + ": no such scene in the suite" + did_you_mean(name, suite) +
                             " (zproof list shows it)"};
}

void print(const SuiteEntry& entry) {
    std::cout << entry.name << "\n    " << entry.reason << "\n    must show:";
    for (const std::string& expected : entry.expects) std::cout << " " << expected;
    std::cout << "\n";
}

}  // namespace

ExitCode execute(const ListArguments& arguments) {
    if (arguments.detail == ListArguments::Detail::names) {
        for (const std::string& name : all_names()) std::cout << name << "\n";
        return ExitCode::proven;
    }
    for (const SuiteEntry& entry : suite_manifest()) print(entry);
    for (const SuiteEntry& entry : thorough_manifest()) {
        print(entry);
        std::cout << "    only of a run with --thorough, or where it is named\n";
    }
    return ExitCode::proven;
}

ExitCode execute(const GenerateArguments& arguments) {
    const std::vector<std::string> names =
        arguments.names.empty() ? names_of(suite_manifest()) : arguments.names;
    require_in_the_suite(names);
    return write_scenes(names, arguments.common,
                        [](const std::string& name) { return generate_suite_scene(name); });
}

ExitCode execute(const RandomScenesArguments& arguments) {
    std::vector<std::string> names = arguments.random.words();
    for (std::string& name : names) std::ranges::replace(name, ':', '-');
    return write_scenes(names, arguments.common, [](const std::string& name) {
        std::string word = name;
        std::ranges::replace(word, '-', ':');
        Loaded loaded = generate(random_scene_from(word).value());
        loaded.scene.name = name;
        return loaded;
    });
}

}  // namespace zproof
