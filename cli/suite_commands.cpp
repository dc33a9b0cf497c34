#include <algorithm>
#include <iostream>

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

void require_in_the_suite(const std::vector<std::string>& requested) {
    std::vector<std::string> suite = names_of(suite_manifest());
    for (const SuiteEntry& entry : thorough_manifest()) suite.push_back(entry.name);
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

ExitCode execute(const ListArguments&) {
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
