#include "scenes/gltf/model.h"

#include <algorithm>
#include <utility>

#include "scenes/gltf/bake.h"
#include "scenes/gltf/check.h"
#include "scenes/gltf/compression.h"
#include "scenes/json_text.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

/// Views of the bytes that were opened.
struct Container {
    std::string_view json;
    std::span<const unsigned char> bin;
};

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

/// Tells GLB from JSON by its first bytes and checks magic, version, lengths and order of chunks.
Container open_container(const std::filesystem::path& file, const Bytes& bytes) {
    if (bytes.empty()) refuse(file, "file", "is empty; expected glTF 2.0 JSON or a GLB");
    const bool has_magic = bytes.size() >= 4 && std::equal(magic.begin(), magic.end(), bytes.begin());
    if (has_magic || file.extension() == ".glb") {
        if (!has_magic) refuse(file, at_byte(0), "expected the magic \"glTF\" of a GLB" + std::string(again));
        return open_glb(file, bytes);
    }
    return {text_in(file, bytes), {}};
}

/// The structure that the JSON states.
GltfModel parsed(const std::filesystem::path& file, const Container& container) {
    const nlohmann::json document = parse_json(file, container.json);
    check_schema(file, document);
    GltfModel model;
    model.file = file;
    model.chunk = container.bin;
    if (const auto animations = document.find("animations"); animations != document.end())
        model.animations = animations->size();
    try {
        document.get_to(model.document);
    } catch (const nlohmann::json::exception& error) {
        refuse(file, "glTF", std::string("cannot be read: ") + error.what());
    }
    return model;
}

/// The files are all looked at before the first is read.
void read_buffers(Admission& admission, GltfModel& model) {
    const std::set<int> without_bytes = stand_ins(model);
    std::vector<std::pair<Bytes*, AdmittedFile>> files;
    for (std::size_t i = 0; i < model.document.buffers.size(); ++i) {
        gltf::Buffer& buffer = model.document.buffers[i];
        if (without_bytes.contains(static_cast<int>(i))) continue;
        if (buffer.uri.empty())
            buffer.chunk = model.chunk.first(buffer.byteLength);
        else if (tinygltf::IsDataURI(buffer.uri))
            buffer.own = decoded_uri(std::exchange(buffer.uri, "")).bytes;
        else
            files.emplace_back(&buffer.own,
                               admission.admit(pointer("buffers", i, "/uri"), buffer.uri, buffer.byteLength));
    }
    for (const auto& [to, file] : files) {
        to->resize(file.bytes);
        read_first(file.path, *to);
    }
}

}  // namespace

int component_count(std::string_view type) {
    if (type == "SCALAR") return 1;
    const int side = type.back() - '0';
    return type.starts_with("MAT") ? side * side : side;
}

DecodedUri decoded_uri(const std::string& uri) {
    std::vector<unsigned char> bytes;
    DecodedUri decoded;
    tinygltf::DecodeDataURI(&bytes, decoded.type, uri, 0, false);
    decoded.bytes.assign(bytes.begin(), bytes.end());
    return decoded;
}

GltfModel read_gltf(const std::filesystem::path& file) {
    Bytes bytes = read_file(file, limits::file_bytes);
    GltfModel model = parsed(file, open_container(file, bytes));
    if (model.chunk.data() != nullptr) model.bytes = std::move(bytes);
    model.notes = check_model(model);
    Admission admission(file);
    read_buffers(admission, model);
    decode_compressed(model);
    read_images(admission, model);
    return model;
}

}  // namespace zproof
