// Models as scenes, beside reading the same file's bytes and having tinygltf parse them, which also decodes
// every picture of the model; zproof decodes those that it uses, checks what it reads, and bakes.
#include <tiny_gltf.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/lazy.h"
#include "bench/scenes.h"
#include "bench/suites.h"
#include "scenes/glb_writer.h"
#include "scenes/gltf/gltf.h"
#include "tests/support/test_folder.h"

namespace zproof::bench {
namespace {

namespace fs = std::filesystem;

tinygltf::Model parse(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<unsigned char> bytes(fs::file_size(file));
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    tinygltf::TinyGLTF parser;
    tinygltf::Model model;
    std::string error, warning;
    const auto size = unsigned(bytes.size());
    const bool is_read = file.extension() == ".glb"
                             ? parser.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size,
                                                           file.parent_path().string())
                             : parser.LoadASCIIFromString(&model, &error, &warning,
                                                          reinterpret_cast<const char*>(bytes.data()), size,
                                                          file.parent_path().string());
    if (!is_read) throw std::runtime_error(file.string() + ": " + error);
    return model;
}

void add_model(const std::string& name, const fs::path& file) {
    add("load/" + name + "/zproof", [=] { benchmark::DoNotOptimize(load_gltf(file)); });
    add("load/" + name + "/bytes and tinygltf", [=] { benchmark::DoNotOptimize(parse(file)); });
}

/// The rippled sheet as a .glb, removed in the end.
class GeneratedModel {
  public:
    GeneratedModel() : file_(folder_.path() / "model.glb") {
        TimedScene timed = ripples();
        timed.scene.parts.push_back({.node = "sheet",
                                     .mesh = "sheet",
                                     .triangle_count = std::uint32_t(timed.scene.triangles.size())});
        timed.scene.materials.emplace_back();
        write_glb_file(file_, timed.scene);
    }
    const fs::path& file() const { return file_; }

  private:
    TestFolder folder_;
    fs::path file_;
};

}  // namespace

void add_load() {
    const fs::path models = fs::path(ZPROOF_SOURCE_DIR).parent_path() / "shared" / "models";
    for (const std::string name : {"Bike/Bike.glb", "DreamApartment/DreamApartment.glb", "zdm2/zdm2.glb"})
        if (const fs::path file = models / name; fs::exists(file)) add_model(file.stem().string(), file);
    const Lazy<std::unique_ptr<GeneratedModel>> sheet{[] { return std::make_unique<GeneratedModel>(); }};
    add("load/a million triangles/zproof", [=] { benchmark::DoNotOptimize(load_gltf((*sheet)->file())); });
    add("load/a million triangles/bytes and tinygltf",
        [=] { benchmark::DoNotOptimize(parse((*sheet)->file())); });
}

}  // namespace zproof::bench
