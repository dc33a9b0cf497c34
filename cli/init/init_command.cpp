#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/example_files.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "program/shell_line.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// A renderer to begin with, which is proven on the scene `room`.
struct Beginning {
    std::string renderer, helper;   ///< files of examples/
    std::string build;              ///< a line for a shell; empty: there is nothing to build
    std::string command;            ///< that zproof runs
    std::string precision;          ///< what it promises
    int width = 320, height = 180;  ///< of its pictures: they come in seconds
    std::string debian_packages;    ///< that it needs
};

Beginning beginning_in(InitArguments::Language language) {
    using enum InitArguments::Language;
    switch (language) {
        case python:
            return {.renderer = "zbuffer.py",
                    .helper = "zproof_contract.py",
                    .build = "",
                    .command = "python3 zbuffer.py",
                    .precision = "raster,transform=float64,interpolation=float64,depth_roundings=1",
                    .debian_packages = "python3"};
        case cpp:
            return {.renderer = "caster.cpp",
                    .helper = "zproof_contract.h",
                    .build = "g++ -O2 -std=c++17 -o caster caster.cpp",
                    .command = "./caster",
                    .precision = "ray,arithmetic=float64",
                    .width = 160,
                    .height = 90,
                    .debian_packages = "g++"};
        case opengl:
            break;
    }
    return {.renderer = "opengl.cpp",
            .helper = "zproof_contract.h",
            .build = "g++ -O2 -std=c++17 -o opengl opengl.cpp -lOpenGL -lEGL",
            .command = "./opengl",
            .precision = "opengl,origin=eye",
            .debian_packages = "g++ libegl-dev libopengl-dev libgl1-mesa-dri"};
}

std::string settings_text(const Beginning& b) {
    return "# What `zproof run` judges in this folder; `zproof doctor` shows every setting.\n"
           "scenes = [\"room\"]  # add models of your own: .gltf, .glb, .obj, .ply\n"
           "renderer = \"" +
           b.command +
           " {scene} {camera} {width} {height} {out}\"\n"
           "precision = \"" +
           b.precision + "\"\nwidth = " + std::to_string(b.width) + "\nheight = " + std::to_string(b.height) +
           "\noracle = [\"none\"]  # beside Embree: \"povray\", \"opengl\"\n";
}

std::string workflow_text(const Beginning& b) {
    return "# zproof as a gate. Name the owner of zproof's repository where OWNER stands.\n"
           "name: zproof\n"
           "on: [push, pull_request]\n"
           "jobs:\n"
           "  zproof:\n"
           "    runs-on: ubuntu-latest\n"
           "    container: debian:12\n"
           "    steps:\n"
           "      - uses: actions/checkout@v4\n"
           "      - run: apt-get update && apt-get install -y --no-install-recommends " +
           b.debian_packages + "\n" + (b.build.empty() ? "" : "      - run: " + b.build + "\n") +
           "      - uses: OWNER/zproof@v0.2.0  # judges what zproof.toml says\n";
}

struct NewFile {
    std::string name, meaning;
    std::string text;
};

std::vector<NewFile> files_of(const Beginning& b) {
    return {{b.renderer, "a renderer that is right; put yours in its place",
             std::string{example_file(b.renderer)}},
            {b.helper, "reads scene and camera, writes the frame", std::string{example_file(b.helper)}},
            {"zproof.toml", "what is judged, and what the renderer promises", settings_text(b)},
            {".github/workflows/zproof.yml", "the same as a gate of GitHub Actions", workflow_text(b)}};
}

bool holds(const fs::path& file, const std::string& text) {
    std::ifstream in{file, std::ios::binary};
    return fs::is_regular_file(file) && std::string{std::istreambuf_iterator{in}, {}} == text;
}

/// What somebody has written is never replaced.
void refuse_what_is_there(const fs::path& folder, const std::vector<NewFile>& files) {
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw UsageError{folder.string() + ": is no folder; expected one after -o, there or new"};
    for (const NewFile& file : files)
        if (const fs::path path = folder / file.name;
            fs::exists(fs::symlink_status(path)) && !holds(path, file.text))
            throw UsageError{path.string() +
                             ": is there already, with other words in it; expected a folder without it, such "
                             "as -o judged"};
}

}  // namespace

ExitCode execute(const InitArguments& arguments) {
    const fs::path& folder = arguments.common.out;
    const Beginning beginning = beginning_in(arguments.language);
    const std::vector<NewFile> files = files_of(beginning);
    refuse_what_is_there(folder, files);
    for (const NewFile& file : files) {
        fs::create_directories((folder / file.name).parent_path());
        write_whole_file(folder / file.name, file.text);
        if (!arguments.common.is_quiet())
            std::cout << one_line((folder / file.name).string()) << ": " << file.meaning << "\n";
    }
    std::cout << "next: " << (folder == "." ? "" : "cd " + shell_quoted(folder.string()) + " && ")
              << beginning.build << (beginning.build.empty() ? "" : " && ") << "zproof run\n";
    return ExitCode::proven;
}

}  // namespace zproof
