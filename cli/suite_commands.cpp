#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/nearest_word.h"
#include "cli/written_scenes.h"
#include "scenes/random_scenes.h"
#include "scenes/scene_error.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

std::vector<std::string> names_of_suite() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

void require_known(const std::vector<std::string>& requested, const std::vector<std::string>& suite) {
    for (const std::string& name : requested)
        if (std::ranges::find(suite, name) == suite.end())
            throw SceneError{name + ": no such scene in the suite" + did_you_mean(name, suite) +
                             " (zproof list shows it)"};
}

}  // namespace

ExitCode execute(const ListArguments&) {
    for (const SuiteEntry& entry : suite_manifest()) {
        std::cout << entry.name << "\n    " << entry.reason << "\n";
        if (entry.expects.empty()) continue;
        std::cout << "    must show:";
        for (const std::string& expected : entry.expects) std::cout << " " << expected;
        std::cout << "\n";
    }
    return ExitCode::proven;
}

ExitCode execute(const GenerateArguments& arguments) {
    const std::vector<std::string> suite = names_of_suite();
    const std::vector<std::string> names = arguments.names.empty() ? suite : arguments.names;
    require_known(names, suite);
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

ExitCode execute(const Answered& answered) {
    std::cout << answered.text;
    return ExitCode::proven;
}

}  // namespace zproof
