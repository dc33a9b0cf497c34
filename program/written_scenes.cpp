#include "program/written_scenes.h"

#include <iostream>

#include "frame/printable.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/work_progress.h"
#include "reports/output_folder.h"
#include "scenes/glb_writer.h"

namespace zproof {

ExitCode write_scenes(const std::vector<std::string>& names, const CommonArguments& common,
                      const std::function<Loaded(const std::string&)>& scene_named) {
    OutputFolder out{common.out};
    note_interrupts();
    WorkProgress progress{std::cerr, progress_beside_lines(common), double(names.size())};
    std::size_t written = 0;
    for (; written < names.size() && !interrupted(); ++written) {
        progress.begin(names[written]);
        write_glb(out.working(), scene_named(names[written]));
        const std::filesystem::path file = common.out / (names[written] + ".view.json");
        if (!common.is_quiet()) progress.say(std::cout, file.string() + "\n");
    }
    const std::filesystem::path place = publish(out, common);
    if (common.is_quiet()) std::cout << one_line(place.string()) << "\n";
    if (written == names.size()) return ExitCode::proven;
    return say_interrupted({written, names.size()}, "scene", "written");
}

}  // namespace zproof
