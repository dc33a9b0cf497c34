#include "scenes/gltf/decoders.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>

namespace zproof {
namespace {

/// The only bitstream that KHR_draco_mesh_compression allows.
constexpr int bitstream_major = 2, bitstream_minor = 2;

draco::DecoderBuffer buffer_of(std::span<const unsigned char> stream) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
    return buffer;
}

bool skip_metadata(draco::DecoderBuffer& buffer) {
    draco::GeometryMetadata metadata;
    return draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
}

/// glTF's number for a type of the stream; 0 for one that glTF has not.
int component_type_of(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return 5120;
        case draco::DT_UINT8:
            return 5121;
        case draco::DT_INT16:
            return 5122;
        case draco::DT_UINT16:
            return 5123;
        case draco::DT_UINT32:
            return 5125;
        case draco::DT_FLOAT32:
            return 5126;
        default:
            return 0;
    }
}

std::string named(const DracoAttribute& attribute) {
    return "attribute " + std::to_string(attribute.id) + " of the Draco stream ";
}

/// Why the attribute is not what the file says, or nothing.
std::string fault_of_attribute(const draco::PointAttribute* found, const DracoAttribute& expected) {
    if (found == nullptr) return named(expected) + "is not there";
    if (component_type_of(found->data_type()) == expected.component_type &&
        found->num_components() == expected.components)
        return {};
    return named(expected) + "has " + std::to_string(found->num_components()) + " components of type " +
           std::to_string(component_type_of(found->data_type())) + "; its accessor says " +
           std::to_string(expected.components) + " of type " + std::to_string(expected.component_type);
}

/// The values by vertex, as the stream has them; nothing where it points beyond its own values.
Bytes values_of(const draco::PointAttribute& attribute, std::uint32_t vertices) {
    const auto size = static_cast<std::size_t>(attribute.byte_stride());
    Bytes bytes(size * vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
        if (value.value() >= attribute.size()) return {};
        attribute.GetValue(value, bytes.data() + size * i);
    }
    return bytes;
}

/// Why the stream's header and the file disagree, or nothing.
std::string fault_of_header(std::span<const unsigned char> stream, const DracoMesh& mesh) {
    const std::optional<std::uint64_t> triangles = draco_triangles(stream);
    if (!triangles) return "expected a triangle mesh of Draco's bitstream 2.2";
    if (mesh.corners && 3 * *triangles != *mesh.corners)
        return "the Draco stream has " + std::to_string(*triangles) +
               " triangles; the accessor of its indices has " + std::to_string(*mesh.corners) +
               " elements, expected three for each";
    if (mesh.vertices > 3 * *triangles)
        return "the accessors have " + std::to_string(mesh.vertices) +
               " vertices, the Draco stream at most " + std::to_string(3 * *triangles);
    return {};
}

DecodedDraco read_mesh(const draco::Mesh& mesh, const DracoMesh& expected) {
    if (mesh.num_points() != expected.vertices)
        return {{},
                {},
                "the Draco stream has " + std::to_string(mesh.num_points()) +
                    " vertices; its accessors have " + std::to_string(expected.vertices)};
    DecodedDraco decoded;
    for (const DracoAttribute& each : expected.attributes) {
        const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(each.id);
        if (std::string fault = fault_of_attribute(attribute, each); !fault.empty())
            return {{}, {}, std::move(fault)};
        decoded.attributes.push_back(values_of(*attribute, mesh.num_points()));
        if (decoded.attributes.back().empty()) return {{}, {}, named(each) + "lacks values"};
    }
    decoded.indices.reserve(3 * std::size_t{mesh.num_faces()});
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i)))
            decoded.indices.push_back(corner.value());
    return decoded;
}

}  // namespace

bool has_draco() { return true; }

std::optional<std::uint64_t> draco_triangles(std::span<const unsigned char> stream) {
    draco::DecoderBuffer buffer = buffer_of(stream);
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return std::nullopt;
    if (header.encoder_type != draco::TRIANGULAR_MESH || header.version_major != bitstream_major ||
        header.version_minor != bitstream_minor)
        return std::nullopt;
    buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(bitstream_major, bitstream_minor));
    if ((header.flags & METADATA_FLAG_MASK) != 0 && !skip_metadata(buffer)) return std::nullopt;
    std::uint8_t traversal = 0;
    std::uint32_t vertices = 0, triangles = 0;
    const bool is_edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
    const bool is_read =
        !is_edgebreaker || (buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer));
    if (!is_read || !draco::DecodeVarint(&triangles, &buffer)) return std::nullopt;
    return triangles;
}

DecodedDraco decode_draco(std::span<const unsigned char> stream, const DracoMesh& mesh) {
    if (std::string fault = fault_of_header(stream, mesh); !fault.empty()) return {{}, {}, std::move(fault)};
    draco::DecoderBuffer buffer = buffer_of(stream);
    draco::Decoder decoder;
    const auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        return {{}, {}, std::string("Draco cannot decode it: ") + decoded.status().error_msg_string()};
    return read_mesh(*decoded.value(), mesh);
}

}  // namespace zproof
