#include "scenes/gltf/container.h"

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

void write_u32(Bytes& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<unsigned char>(value >> (8 * i));
}

void append_u32(Bytes& bytes, std::uint32_t value) {
    bytes.resize(bytes.size() + 4);
    write_u32(bytes, bytes.size() - 4, value);
}

/// Padded to a multiple of 4 bytes.
void append_chunk(Bytes& bytes, std::uint32_t type, std::span<const unsigned char> content,
                  unsigned char padding) {
    const std::size_t length = (content.size() + 3) / 4 * 4;
    append_u32(bytes, static_cast<std::uint32_t>(length));
    append_u32(bytes, type);
    bytes.insert(bytes.end(), content.begin(), content.end());
    bytes.insert(bytes.end(), length - content.size(), padding);
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

/// The length of the chunk whose header is there.
std::size_t chunk_length(const std::filesystem::path& file, const Bytes& bytes, std::size_t at) {
    if (bytes.size() - at < 8)
        refuse(file, at_byte(at), "expected a chunk header of 8 bytes" + std::string(again));
    const std::size_t length = read_u32(bytes, at);
    if (length > bytes.size() - at - 8)
        refuse(file, at_byte(at),
               "chunk of " + std::to_string(length) + " bytes runs past the file's end" + std::string(again));
    if (length % 4 != 0)
        refuse(file, at_byte(at), "expected a chunk length that is a multiple of 4" + std::string(again));
    return length;
}

Container open_glb(const std::filesystem::path& file, const Bytes& bytes) {
    check_header(file, bytes);
    Container glb;
    std::size_t at = 12;
    for (int number = 0; number == 0 || at < bytes.size(); ++number) {
        const std::size_t length = chunk_length(file, bytes, at);
        const std::uint32_t type = read_u32(bytes, at + 4);
        if ((type == chunk_json) != (number == 0) || (type == chunk_bin && number > 1))
            refuse(file, at_byte(at),
                   "expected one JSON chunk, then at most one BIN chunk" + std::string(again));
        const std::span<const unsigned char> content = std::span(bytes).subspan(at + 8, length);
        if (type == chunk_json) glb.json = {reinterpret_cast<const char*>(content.data()), length};
        if (type == chunk_bin) glb.bin = content;
        at += 8 + length;
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

Bytes packed_glb(const Container& container) {
    const std::span json(reinterpret_cast<const unsigned char*>(container.json.data()),
                         container.json.size());
    Bytes bytes;
    bytes.reserve(json.size() + container.bin.size() + 40);
    for (const char c : magic) bytes.push_back(static_cast<unsigned char>(c));
    append_u32(bytes, 2);
    append_u32(bytes, 0);  // the length, which is not known yet
    append_chunk(bytes, chunk_json, json, ' ');
    append_chunk(bytes, chunk_bin, container.bin, 0);
    write_u32(bytes, 8, static_cast<std::uint32_t>(bytes.size()));
    return bytes;
}

}  // namespace zproof
