/// Anybody's renderer, run as a program by the contract of docs/renderer-contract.md.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "frame/convention.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "image_io/image_io.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

class ScratchFolder;

/// A scene written where a program can read it. The scene must outlive this object.
class External {
  public:
    /// The command is a line for /bin/sh in which {scene} (binary glTF), {camera} (JSON), {width}, {height}
    /// and {out} (the frame, to be written) stand for the words that they name, quoted. It runs in the
    /// current folder, for at most time_limit a picture, and writes frames in this convention. Throws
    /// OracleError where the scene cannot be written.
    External(const Scene& scene, std::string command, std::chrono::seconds time_limit,
             Convention convention = {}, IdChannel ids = IdChannel::present);
    ~External();
    External(External&&) noexcept;
    External& operator=(External&&) noexcept;

    /// Runs the command once. Throws OracleError, with the end of what it wrote to standard error, where it
    /// fails, is too slow, or leaves anything but a frame of the view's size in its convention. The frame is
    /// {out}, or {out}.SUFFIX, or two files, {out}.id.SUFFIX and {out}.depth.SUFFIX. The values themselves
    /// are not judged here.
    Frame render(const View& view) const;
    /// The names of the channels of the file that the last render() read; none where there is none.
    std::vector<std::string> channels() const;
    /// The picture of a program that writes R, G and B, in linear light. Throws as render().
    Picture render_picture(const View& view) const;

  private:
    /// Runs the command for the view; `read` makes of the file that it wrote what is wanted.
    template <class Read>
    auto answer(const View& view, const Read& read) const;
    /// The limit covers reading the answer.
    std::chrono::milliseconds time_left(std::chrono::steady_clock::time_point begun) const;

    std::string command_;
    std::chrono::seconds time_limit_;
    Convention convention_;
    IdChannel ids_;
    std::unique_ptr<const ScratchFolder> folder_;
};

}  // namespace zproof::oracle
