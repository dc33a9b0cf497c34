#include "oracle/external.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "frame/frame_error.h"
#include "oracle/convention/stored_frame.h"
#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"
#include "oracle/subprocess.h"
#include "scenes/glb_writer.h"
#include "scenes/scene_error.h"
#include "scenes/view_document.h"

namespace zproof::oracle {

namespace {

namespace fs = std::filesystem;
using Meaning = std::pair<std::string, std::string>;  ///< a word in braces and what stands for it

/// Quotes a word for /bin/sh: within single quotes every character but the quote itself stands for itself.
std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return text + "'";
}

/// One pass from left to right, so that nothing is replaced within what was put in.
template <std::size_t Count>
std::string filled_in(const std::string& command, const std::array<Meaning, Count>& meanings) {
    std::string line;
    for (std::size_t i = 0; i < command.size();) {
        const Meaning* here = nullptr;
        for (const Meaning& meaning : meanings)
            if (command.compare(i, meaning.first.size(), meaning.first) == 0) here = &meaning;
        line += here == nullptr ? std::string{command[i]} : here->second;
        i += here == nullptr ? 1 : here->first.size();
    }
    return line;
}

/// The text with the command's own words for the files of this folder, which no other run has.
std::string as_typed(std::string text, const fs::path& folder) {
    using Name = std::pair<const char*, const char*>;
    for (const auto& [file, word] :
         {Name{"scene.glb", "{scene}"}, Name{"camera.json", "{camera}"}, Name{"frame.exr", "{out}"}}) {
        const std::string path = (folder / file).string();
        for (std::size_t at; (at = text.find(path)) != std::string::npos;)
            text.replace(at, path.size(), word);
    }
    return text;
}

/// What the program said last, as the end of a sentence.
std::string what_it_said(const Outcome& outcome, const fs::path& folder) {
    const std::string said = last_output(outcome);
    return said.empty() ? "" : "; it said: " + as_typed(said, folder);
}

/// What lies beside `out` under its name and a suffix.
std::vector<fs::path> files_beside(const fs::path& out) {
    std::vector<fs::path> files;
    std::error_code failure;
    for (auto i = fs::directory_iterator(out.parent_path(), failure); !failure && i != end(i);
         i.increment(failure))
        if (i->path().filename().string().starts_with(out.filename().string() + "."))
            files.push_back(i->path());
    std::ranges::sort(files);
    return files;
}

void remove_answer(const fs::path& out) {
    std::error_code ignored;
    fs::remove(out, ignored);
    for (const fs::path& file : files_beside(out)) fs::remove(file, ignored);
}

/// The file or the two files that the program wrote, as a frame is named.
fs::path answer_at(const fs::path& out) {
    std::error_code ignored;  // of a loop of links: the reader tells it
    if (fs::exists(out, ignored)) return out;
    fs::path ids, depths, other;
    for (const fs::path& file : files_beside(out)) {
        const std::string name = file.string();
        (name.starts_with(out.string() + ".id.")      ? ids
         : name.starts_with(out.string() + ".depth.") ? depths
                                                      : other) = file;
    }
    if (!ids.empty() && !depths.empty()) return ids.string() + "+" + depths.string();
    return other.empty() ? out : other;
}

}  // namespace

External::External(const Scene& scene, std::string command, std::chrono::seconds time_limit,
                   Convention convention, IdChannel ids)
    : command_(std::move(command)),
      time_limit_(time_limit),
      convention_(std::move(convention)),
      ids_(ids),
      folder_(std::make_unique<ScratchFolder>()) {
    try {
        write_glb_file(folder_->path() / "scene.glb", scene);
    } catch (const SceneError& e) {
        throw OracleError{e.what()};
    }
}

External::~External() = default;
External::External(External&&) noexcept = default;
External& External::operator=(External&&) noexcept = default;

std::chrono::milliseconds External::time_left(std::chrono::steady_clock::time_point begun) const {
    const auto left = time_limit_ - (std::chrono::steady_clock::now() - begun);
    return std::chrono::ceil<std::chrono::milliseconds>(left);
}

template <class Read>
auto External::answer(const View& view, const Read& read) const {
    const fs::path camera = folder_->path() / "camera.json", out = folder_->path() / "frame.exr";
    folder_->write("camera.json", camera_document(view));
    remove_answer(out);  // the last view's: a program that writes nothing must not pass with it
    const std::string line = filled_in(
        command_, std::array<Meaning, 8>{{{"{scene}", quoted((folder_->path() / "scene.glb").string())},
                                          {"{camera}", quoted(camera.string())},
                                          {"{width}", std::to_string(view.width)},
                                          {"{height}", std::to_string(view.height)},
                                          {"{out}", quoted(out.string())},
                                          {"{sample}", std::to_string(view.sample.index)},
                                          {"{sample_x}", px_text(view.sample.offset_px.x)},
                                          {"{sample_y}", px_text(view.sample.offset_px.y)}}});
    const auto begun = std::chrono::steady_clock::now();
    const Outcome outcome = run({.arguments = shell_line(line), .time_limit = time_limit_});
    if (!outcome.succeeded())
        throw OracleError{"renderer '" + command_ + "': " + in_words(outcome, time_limit_) +
                          what_it_said(outcome, folder_->path())};
    try {
        return read(answer_at(out), time_left(begun));
    } catch (const FrameError& e) {
        throw OracleError{"renderer '" + command_ + "': " + as_typed(e.what(), folder_->path()) +
                          what_it_said(outcome, folder_->path())};
    }
}

Frame External::render(const View& view) const {
    return answer(view, [&](const fs::path& file, std::chrono::milliseconds time_limit) {
        return read_stored_frame(file, convention_, view, ids_, time_limit);
    });
}

std::vector<std::string> External::channels() const {
    try {
        return stored_frame_channels(answer_at(folder_->path() / "frame.exr"), time_limit_);
    } catch (const FrameError&) {
        return {};
    }
}

Picture External::render_picture(const View& view) const {
    return answer(view, [&](const fs::path& file, std::chrono::milliseconds time_limit) {
        return read_stored_picture(file, view, time_limit);
    });
}

}  // namespace zproof::oracle
