#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/nearest_word.h"
#include "cli/published.h"
#include "cli/work_progress.h"
#include "frame/printable.h"
#include "reports/output_folder.h"
#include "scenes/glb_writer.h"
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
    OutputFolder out{arguments.common.out};
    note_interrupts();
    WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(names.size())};
    std::size_t written = 0;
    for (; written < names.size() && !interrupted(); ++written) {
        progress.begin(names[written]);
        write_glb(out.working(), generate_suite_scene(names[written]));
        const std::filesystem::path file = arguments.common.out / (names[written] + ".view.json");
        if (!arguments.common.is_quiet()) progress.say(std::cout, file.string() + "\n");
    }
    const std::filesystem::path place = publish(out, arguments.common);
    if (arguments.common.is_quiet()) std::cout << one_line(place.string()) << "\n";
    if (written == names.size()) return ExitCode::proven;
    return say_interrupted({written, names.size()}, "scene", "written");
}

ExitCode execute(const Answered& answered) {
    std::cout << answered.text;
    return ExitCode::proven;
}

}  // namespace zproof
