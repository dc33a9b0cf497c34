/// Every malformed or hostile file of the shared corpus: refused in one clear line, or loaded with a note.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/gltf/gltf.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(ZPROOF_SHARED) / "models" / "malformed";
constexpr std::size_t corpus_size = 114;

/// Usable after all, with a part of the note that says why (docs/scenes.md).
const std::map<std::string, std::string> loads_after_all{
    {"draco/Box/glTF_Binary/Box_Draco.glb", ""},
    {"generated/gen_degenerate_flat.glb", "triangles without area"},
    {"generated/gen_huge_coordinates.gltf", "squares overflow float32"},
    {"generated/gen_image_wrong_mime.glb", "declared image/jpeg, is image/png"},
    {"generated/gen_indices_not_multiple_of_3.gltf", "last one or two corners make no triangle"},
    {"generated/gen_instancing_bad.gltf", "EXT_mesh_gpu_instancing drawn once only"},
    {"generated/gen_required_extension.gltf", ""},
    {"generated/gen_texcoord_set_missing.glb", "no primitive has their uv set"},
    {"gltf-pipeline/EXT_meshopt_compression/meshopt-no-fallback/meshopt-no-fallback.gltf", ""},
    {"magnum-plugins/GltfImporter/Test/scene-invalid-multiple-parents.gltf", "several parents"},
    {"tinygltf/models/regression/zero-sized-bin-chunk-issue-440.glb", ""},
};

std::vector<fs::path> corpus_files() {
    std::vector<fs::path> files;
    if (!fs::is_directory(corpus)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(corpus))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The largest resident set so far, in MiB.
long peak_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

void expect_one_clear_line(const fs::path& file, const std::string& message) {
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
    EXPECT_GT(message.size(), file.string().size() + 20) << "names no place and expectation: " << message;
    EXPECT_LT(message.size(), file.string().size() + 700) << message;
}

void expect_sound(const Scene& scene) {
    for (const glm::vec3& p : scene.vertices.position_world)
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const glm::uvec3& triangle : scene.triangles)
        ASSERT_LT(std::max({triangle.x, triangle.y, triangle.z}), scene.vertices.position_world.size());
}

void expect_note(const Loaded& loaded, const std::string& part) {
    if (part.empty()) return;  // nothing is wrong with the file
    const auto& notes = loaded.scene.notes;
    EXPECT_TRUE(
        std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != note.npos; }))
        << "expected a note with \"" << part << "\"";
}

TEST(MalformedCorpus, IsThere) {
    EXPECT_EQ(corpus_files().size(), corpus_size) << "expected the shared corpus in " << corpus;
}

TEST(MalformedCorpus, IsRefusedInOneLineOrLoadsWithANote) {
    std::size_t loaded_files = 0;
    for (const fs::path& file : corpus_files()) {
        const std::string name = file.lexically_relative(corpus).string();
        SCOPED_TRACE(name);
        const auto expected = loads_after_all.find(name);
        try {
            const Loaded loaded = load_gltf(file);
            std::string notes;
            for (const std::string& note : loaded.scene.notes) notes += note + " | ";
            EXPECT_NE(expected, loads_after_all.end()) << "loads, notes: " << notes;
            if (expected != loads_after_all.end()) expect_note(loaded, expected->second);
            expect_sound(loaded.scene);
            ++loaded_files;
        } catch (const SceneError& error) {
            EXPECT_EQ(expected, loads_after_all.end()) << error.what();
            expect_one_clear_line(file, error.what());
        }
    }
    EXPECT_EQ(loaded_files, loads_after_all.size());
    EXPECT_LT(peak_mib(), 600) << "no file of the corpus needs more than a few MiB";
}

}  // namespace
}  // namespace zproof
