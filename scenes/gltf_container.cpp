#include "scenes/gltf_container.h"

#include <algorithm>
#include <string>

#include "scenes/refusal.h"

namespace zproof {
namespace {

constexpr std::uint32_t chunk_json = 0x4E4F534A, chunk_bin = 0x004E4942;
constexpr std::string_view magic = "glTF";
constexpr std::string_view again = "; export the file again";

std::uint32_t read_u32(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

std::string at_byte(std::size_t byte) { return "byte " + std::to_string(byte); }

void check_header(const std::filesystem::path& file, const Bytes& bytes) {
    if (bytes.size() < 12) refuse(file, "GLB header", std::string("expected 12 bytes") + std::string(again));
    if (const std::uint32_t version = read_u32(bytes, 4); version != 2)
        refuse(file, at_byte(4), "expected GLB version 2, found " + std::to_string(version));
    if (const std::uint32_t length = read_u32(bytes, 8); length != bytes.size())
        refuse(file, at_byte(8),
               "expected the file's length " + std::to_string(bytes.size()) + ", found " +
                   std::to_string(length) + std::string(again));
}

struct Chunk {
    std::uint32_t type = 0;
    std::size_t first = 0, length = 0;
};

Chunk chunk_at(const std::filesystem::path& file, const Bytes& bytes, std::size_t at) {
    if (bytes.size() - at < 8)
        refuse(file, at_byte(at), "expected a chunk header of 8 bytes" + std::string(again));
    const Chunk chunk{read_u32(bytes, at + 4), at + 8, read_u32(bytes, at)};
    if (chunk.length > bytes.size() - chunk.first)
        refuse(file, at_byte(at),
               "chunk of " + std::to_string(chunk.length) + " bytes runs past the file's end" +
                   std::string(again));
    if (chunk.length % 4 != 0)
        refuse(file, at_byte(at), "expected a chunk length that is a multiple of 4" + std::string(again));
    return chunk;
}

Container open_glb(const std::filesystem::path& file, const Bytes& bytes) {
    check_header(file, bytes);
    const Chunk json = chunk_at(file, bytes, 12);
    if (json.type != chunk_json)
        refuse(file, at_byte(16), "expected a JSON chunk first" + std::string(again));
    Container glb{{reinterpret_cast<const char*>(bytes.data()) + json.first, json.length}, {}};
    std::size_t at = json.first + json.length;
    for (int number = 1; at < bytes.size(); ++number) {
        const Chunk chunk = chunk_at(file, bytes, at);
        if (chunk.type == chunk_json || (chunk.type == chunk_bin && number > 1))
            refuse(file, at_byte(at), "expected one JSON chunk and at most one BIN chunk, in this order");
        if (chunk.type == chunk_bin) glb.bin = std::span(bytes).subspan(chunk.first, chunk.length);
        at = chunk.first + chunk.length;
    }
    return glb;
}

}  // namespace

Container open_container(const std::filesystem::path& file, const Bytes& bytes) {
    if (bytes.empty()) refuse(file, "file", "is empty; expected glTF 2.0 JSON or a GLB");
    const bool has_magic = bytes.size() >= 4 && std::equal(magic.begin(), magic.end(), bytes.begin());
    if (has_magic || file.extension() == ".glb") {
        if (!has_magic) refuse(file, at_byte(0), "expected the magic \"glTF\" of a GLB" + std::string(again));
        return open_glb(file, bytes);
    }
    return {{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, {}};
}

}  // namespace zproof
