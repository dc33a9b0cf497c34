// A .glb with right lengths around any JSON and any BIN chunk; gltf.cpp has those with wrong ones.
#include "scenes/gltf/gltf.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "tests/fuzz/image_module.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {
namespace {

void append_number(std::string& bytes, std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) bytes += char(number >> shift & 0xFF);
}

/// Filled up to a multiple of 4 bytes.
std::string chunk(const std::string& type, std::string content, char filler) {
    content.resize((content.size() + 3) / 4 * 4, filler);
    std::string bytes;
    append_number(bytes, content.size());
    return bytes + type + content;
}

std::string glb_of(Input json, Input bin) {
    const std::string chunks = chunk("JSON", text_of(json), ' ') + chunk({"BIN\0", 4}, text_of(bin), '\0');
    std::string bytes = "glTF";
    append_number(bytes, 2);
    append_number(bytes, 12 + chunks.size());
    return bytes + chunks;
}

}  // namespace

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto [json, bin] = split_at_zero(input);
    const auto file = folder.write("input.glb", glb_of(json, bin));
    Loaded loaded;
    may_refuse<SceneError>([&] { loaded = load_gltf(file, 64, 48); });
    may_refuse<SceneError>([&] { require_judged(loaded.scene); });
    for (const View& view : loaded.views) may_refuse<SceneError>([&] { require_judged(view); });
}

}  // namespace zproof::fuzz
