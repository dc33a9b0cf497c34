#include "cli/written_scenes.h"

#include <iostream>

#include "cli/interrupt.h"
#include "cli/published.h"
#include "cli/work_progress.h"
#include "reports/output_folder.h"
#include "scenes/glb_writer.h"

namespace zproof {

ExitCode write_scenes(const std::vector<std::string>& names, const std::filesystem::path& folder,
                      const std::function<Loaded(const std::string&)>& scene_named) {
    OutputFolder out{folder};
    note_interrupts();
    WorkProgress progress{std::cerr, beside_lines(ProgressStyle::automatic), double(names.size())};
    std::size_t written = 0;
    for (; written < names.size() && !interrupted(); ++written) {
        progress.begin(names[written]);
        write_glb(out.working(), scene_named(names[written]));
        progress.say(std::cout, (folder / (names[written] + ".view.json")).string() + "\n");
    }
    publish(out, folder);
    if (written == names.size()) return ExitCode::proven;
    return say_interrupted({written, names.size()}, "scene", "written");
}

}  // namespace zproof
