#include <iostream>

#include "cli/commands.h"
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
    OutputFolder out{arguments.out};
    for (const std::string& name : arguments.names.empty() ? names_of_suite() : arguments.names) {
        write_glb(out.working(), generate_suite_scene(name));
        std::cout << (arguments.out / (name + ".view.json")).string() << "\n";
    }
    out.publish();
    return ExitCode::proven;
}

ExitCode execute(const Answered& answered) {
    std::cout << answered.text;
    return ExitCode::proven;
}

}  // namespace zproof
