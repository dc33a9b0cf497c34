#include "oracle/external.h"

#include <array>
#include <utility>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
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

/// What the program said last, as the end of a sentence.
std::string what_it_said(const Outcome& outcome) {
    const std::string said = last_output(outcome);
    return said.empty() ? "" : "; it said: " + said;
}

/// The error message with the command's own word for the file that it is about.
std::string about_out(std::string complaint, const fs::path& out) {
    const std::string path = out.string();
    for (std::size_t at; (at = complaint.find(path)) != std::string::npos;)
        complaint.replace(at, path.size(), "{out}");
    return complaint;
}

Frame read_answer(const fs::path& file, const View& view, IdChannel ids) {
    const Resolution size = frame_size(file, ids);
    if (size == Resolution{view.width, view.height}) return read_frame(file, ids);
    throw FrameError{file.string() + ": " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " pixels; " + std::to_string(view.width) + " x " + std::to_string(view.height) +
                     " were asked for"};
}

}  // namespace

External::External(const Scene& scene, std::string command, std::chrono::seconds time_limit, IdChannel ids)
    : command_(std::move(command)),
      time_limit_(time_limit),
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

Frame External::render(const View& view) const {
    const fs::path camera = folder_->path() / "camera.json", out = folder_->path() / "frame.exr";
    folder_->write("camera.json", camera_document(view));
    std::error_code ignored;
    fs::remove(out, ignored);  // the last view's: a program that writes nothing must not pass with it
    const std::string line = filled_in(
        command_, std::array<Meaning, 5>{{{"{scene}", quoted((folder_->path() / "scene.glb").string())},
                                          {"{camera}", quoted(camera.string())},
                                          {"{width}", std::to_string(view.width)},
                                          {"{height}", std::to_string(view.height)},
                                          {"{out}", quoted(out.string())}}});
    const Outcome outcome = run({.arguments = shell_line(line), .time_limit = time_limit_});
    if (!outcome.succeeded())
        throw OracleError{"renderer '" + command_ + "': " + in_words(outcome, time_limit_) +
                          what_it_said(outcome)};
    try {
        return read_answer(out, view, ids_);
    } catch (const FrameError& e) {
        throw OracleError{"renderer '" + command_ + "': " + about_out(e.what(), out) + what_it_said(outcome)};
    }
}

}  // namespace zproof::oracle
