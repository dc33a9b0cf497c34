#include <algorithm>

#include "lessons/study.h"
#include "program/folder_names.h"
#include "program/interrupt.h"

namespace zproof {
namespace {

std::string in_lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return text;
}

}  // namespace

const std::vector<Study>& studies() {
    static const std::vector<Study> all{projection_study(), depth_study(), shading_study(), cost_study()};
    return all;
}

void each_view(const StudyTask& task, const std::function<void(const StudiedView&)>& study_one) {
    FolderNames names;
    for (const Loaded& subject : task.subjects)
        for (const View& view : subject.views) {
            if (interrupted()) return;
            const std::string title = subject.scene.name + " / " + view.name;
            task.progress.within(title + ": ");
            study_one({subject.scene, view, in_lower_case(names.next(subject.scene.name, view.name)), title});
        }
}

}  // namespace zproof
