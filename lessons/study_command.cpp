#include <algorithm>
#include <iostream>

#include "frame/printable.h"
#include "lessons/arguments.h"
#include "lessons/study.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/study_scenes.h"
#include "program/version.h"
#include "program/work_progress.h"
#include "reports/output_folder.h"
#include "reports/pages/folder.h"
#include "reports/pages/writers.h"

namespace zproof {
namespace {

std::vector<Loaded> subjects_of(const Study& study, const StudyArguments& arguments) {
    const Resolution size{arguments.width.value_or(study.resolution.width),
                          arguments.height.value_or(study.resolution.height)};
    std::vector<Loaded> subjects;
    for (const StudyScene& scene :
         study_scenes(arguments.scenes.empty() ? study.subjects : arguments.scenes)) {
        subjects.push_back(load(scene, size));
        subjects.back().views = chosen_views(subjects.back(), arguments.views);
    }
    return subjects;
}

int units_of(const Study& study, const std::vector<Loaded>& subjects) {
    std::size_t views = 0;
    for (const Loaded& subject : subjects) views += subject.views.size();
    return int(views) * study.units_per_view;
}

document::Document performed(const Study& study, const StudyArguments& arguments) {
    const std::vector<Loaded> subjects = subjects_of(study, arguments);
    WorkProgress progress{std::cerr, progress_of(arguments.common), double(units_of(study, subjects))};
    document::Document document;
    on_threads(arguments.common.threads, [&] { document = study.perform({arguments, subjects, progress}); });
    document.command = arguments.typed;
    document.version = version_number();
    if (interrupted())
        document.introduction.push_back("The study was interrupted: what follows was done until then.");
    return document;
}

}  // namespace

ExitCode execute(const StudyArguments& arguments) {
    const Study& study = *std::ranges::find(studies(), arguments.study, &Study::name);
    OutputFolder out{arguments.common.out};
    note_interrupts();
    const document::Document document = performed(study, arguments);
    document::write_document(out.working(), document);
    const std::filesystem::path place =
        publish(out, arguments.common, interrupted() ? Completeness::partial : Completeness::full);
    if (!arguments.common.is_quiet()) std::cout << document::terminal_text(document) << "\n";
    std::cout << "study: " << one_line((place / "study.html").string()) << "\n";
    return interrupted() ? ExitCode::interrupted : ExitCode::proven;
}

}  // namespace zproof
