// Draco and meshopt: what is decoded is the scene that was encoded, and broken streams are refused.
#include "scenes/gltf/compression.h"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "scenes/gltf/gltf.h"
#include "scenes/scene_hash.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

/// A bumpy square of side x side quads, its corners shared.
struct Sheet {
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;

    explicit Sheet(std::uint32_t side) {
        std::minstd_rand random(7);
        for (std::uint32_t y = 0; y <= side; ++y)
            for (std::uint32_t x = 0; x <= side; ++x)
                for (const float each : {float(x), float(y), float(random() % 1000) / 1024})
                    positions.push_back(each);
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) {
                const std::uint32_t a = y * (side + 1) + x, b = a + side + 1;
                for (const std::uint32_t each : {a, a + 1, b, b, a + 1, b + 1}) indices.push_back(each);
            }
    }
    std::size_t vertices() const { return positions.size() / 3; }
};

std::unique_ptr<draco::Mesh> mesh_of(const Sheet& sheet) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(int(sheet.indices.size() / 3));
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::size_t i = 0; i < sheet.indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) { return &sheet.positions[3 * sheet.indices[corner]]; };
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(std::uint32_t(i / 3)), at(i), at(i + 1),
                                          at(i + 2));
    }
    return builder.Finalize();
}

/// The least error of positions, in scene units, that quantization to `bits` may make: half a step.
double half_step(double range, int bits) { return range / ((1 << bits) - 1) / 2; }

std::vector<char> draco_stream(const draco::Mesh& mesh, int bits, int method) {
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
    return *buffer.buffer();
}

/// A file whose only mesh is the stream.
WrittenGltf draco_gltf(const std::vector<char>& stream, std::size_t vertices, std::size_t corners) {
    WrittenGltf gltf;
    gltf.json["extensionsUsed"] = gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    gltf.add_accessor({{"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}});
    gltf.add_accessor({{"componentType", 5125}, {"count", corners}, {"type", "SCALAR"}});
    gltf.primitive()["indices"] = 1;
    gltf.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", gltf.add_view(stream)},
                                                                    {"attributes", {{"POSITION", 0}}}};
    return gltf;
}

/// The triangle's corners, the one with the least coordinates first, so that triangles can be told apart
/// whichever corner a codec begins with.
std::array<glm::vec3, 3> turned(const Scene& scene, const glm::uvec3& triangle) {
    std::array<glm::vec3, 3> corners;
    for (int i = 0; i < 3; ++i) corners[std::size_t(i)] = scene.vertices.position_world[triangle[i]];
    const auto is_less = [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::ranges::rotate(corners, std::ranges::min_element(corners, is_less));
    return corners;
}

/// All triangles as places, in an order of their own.
std::vector<std::array<float, 9>> as_a_set(const Scene& scene) {
    std::vector<std::array<float, 9>> all;
    for (const glm::uvec3& triangle : scene.triangles) {
        const auto [a, b, c] = turned(scene, triangle);
        all.push_back({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
    }
    std::ranges::sort(all);
    return all;
}

Scene plain_scene(const TestFolder& folder, const Sheet& sheet) {
    WrittenGltf gltf;
    gltf.add_vec3(sheet.positions);
    gltf.primitive()["indices"] = gltf.add_indices(sheet.indices, 5125);
    return load_gltf_scene(gltf.write(folder));
}

TEST(Draco, WithoutQuantizationGivesTheTrianglesThatWereEncodedBitByBit) {
    const TestFolder folder;
    const Sheet sheet(9);
    const auto plain = as_a_set(plain_scene(folder, sheet));
    const auto mesh = mesh_of(sheet);
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const auto stream = draco_stream(*mesh, 0, method);
        const auto gltf = draco_gltf(stream, mesh->num_points(), sheet.indices.size());
        EXPECT_EQ(as_a_set(load_gltf_scene(gltf.write(folder))), plain) << "method " << method;
    }
}

TEST(Draco, QuantizedPositionsLieWithinHalfAStep) {
    const TestFolder folder;
    const Sheet sheet(9);
    const Scene plain = plain_scene(folder, sheet);
    const auto mesh = mesh_of(sheet);
    constexpr int bits = 11;
    const auto stream = draco_stream(*mesh, bits, draco::MESH_SEQUENTIAL_ENCODING);
    const Scene scene =
        load_gltf_scene(draco_gltf(stream, mesh->num_points(), sheet.indices.size()).write(folder));
    ASSERT_EQ(scene.triangles.size(), plain.triangles.size());
    const double rounding = 9 * std::ldexp(1, -22);           // of the sheet's coordinates, in float32
    for (std::size_t i = 0; i < plain.triangles.size(); ++i)  // this method keeps the order of triangles
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(scene.vertices.position_world[scene.triangles[i][corner]][axis],
                            plain.vertices.position_world[plain.triangles[i][corner]][axis],
                            half_step(9, bits) + rounding);
}

TEST(Draco, IdsAreTheOrderOfTheDecodedStream) {
    const TestFolder folder;
    const Sheet sheet(9);
    const auto mesh = mesh_of(sheet);
    const auto stream = draco_stream(*mesh, 0, draco::MESH_EDGEBREAKER_ENCODING);
    draco::DecoderBuffer buffer;
    buffer.Init(stream.data(), stream.size());
    const auto decoded = std::move(draco::Decoder().DecodeMeshFromBuffer(&buffer)).value();
    const Scene scene =
        load_gltf_scene(draco_gltf(stream, mesh->num_points(), sheet.indices.size()).write(folder));
    ASSERT_EQ(scene.triangles.size(), decoded->num_faces());
    for (std::uint32_t i = 0; i < decoded->num_faces(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            ASSERT_EQ(scene.triangles[i][corner],
                      decoded->face(draco::FaceIndex(i))[std::size_t(corner)].value());
}

TEST(Draco, RefusesCountsThatTheStreamDoesNotHave) {
    const TestFolder folder;
    const Sheet sheet(2);
    const auto mesh = mesh_of(sheet);
    const auto stream = draco_stream(*mesh, 0, draco::MESH_EDGEBREAKER_ENCODING);
    const auto refusal = [&](std::size_t vertices, std::size_t corners) {
        return refusal_of(draco_gltf(stream, vertices, corners).write(folder));
    };
    EXPECT_EQ(refusal(9, 24), "loaded");
    EXPECT_NE(refusal(9, 27).find("the Draco stream has 8 triangles; the accessor of its indices has 27"),
              std::string::npos);
    EXPECT_NE(refusal(8, 24).find("the Draco stream has 9 vertices; its accessors have 8"),
              std::string::npos);
    EXPECT_NE(refusal(25, 24).find("25 vertices, the Draco stream at most 24"), std::string::npos);
}

TEST(Draco, RefusesAnotherTypeAndAnAttributeThatIsNotThere) {
    const TestFolder folder;
    const Sheet sheet(2);
    auto gltf = draco_gltf(draco_stream(*mesh_of(sheet), 0, draco::MESH_SEQUENTIAL_ENCODING), 9, 24);
    gltf.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 5;
    EXPECT_NE(refusal_of(gltf.write(folder)).find("attribute 5 of the Draco stream is not there"),
              std::string::npos);
    gltf.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"] = {{"POSITION", 0},
                                                                                  {"NORMAL", 1}};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("Draco has NORMAL; expected it in attributes too"),
              std::string::npos);
    gltf.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"] = {{"POSITION", 0}};
    gltf.primitive()["mode"] = 5;
    EXPECT_NE(refusal_of(gltf.write(folder)).find("expected mode 4"), std::string::npos);
}

/// Every stream that ends too early, or with one byte that is another, is refused or decoded; none crashes.
void expect_no_crash(
    const std::vector<char>& stream,
    const std::function<std::filesystem::path(const TestFolder&, std::vector<char>)>& file_of) {
    const TestFolder folder;
    std::size_t refused = 0;
    for (std::size_t bytes = 1; bytes < stream.size(); ++bytes)
        refused +=
            refusal_of(file_of(folder, {stream.begin(), stream.begin() + std::ptrdiff_t(bytes)})) != "loaded";
    EXPECT_GE(refused, stream.size() - 8) << "only a stream's padding may be missing";
    for (std::size_t i = 0; i < stream.size(); ++i)
        for (const int flip : {1, 0x80, 0xFF}) {
            std::vector<char> other = stream;
            other[i] = char(other[i] ^ flip);
            refusal_of(file_of(folder, other));
        }
}

TEST(Draco, SurvivesStreamsThatAreCutOrChanged) {
    const Sheet sheet(3);
    const auto mesh = mesh_of(sheet);
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
        expect_no_crash(draco_stream(*mesh, 8, method),
                        [&](const TestFolder& folder, const std::vector<char>& stream) {
                            return draco_gltf(stream, mesh->num_points(), sheet.indices.size()).write(folder);
                        });
}

std::vector<unsigned char> meshopt_vertices(const Sheet& sheet) {
    std::vector<unsigned char> stream(meshopt_encodeVertexBufferBound(sheet.vertices(), 12));
    stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), sheet.positions.data(),
                                             sheet.vertices(), 12));
    return stream;
}

std::vector<unsigned char> meshopt_triangles(const Sheet& sheet) {
    std::vector<unsigned char> stream(meshopt_encodeIndexBufferBound(sheet.indices.size(), sheet.vertices()));
    stream.resize(
        meshopt_encodeIndexBuffer(stream.data(), stream.size(), sheet.indices.data(), sheet.indices.size()));
    return stream;
}

std::vector<unsigned char> meshopt_sequence(const Sheet& sheet) {
    std::vector<unsigned char> stream(
        meshopt_encodeIndexSequenceBound(sheet.indices.size(), sheet.vertices()));
    stream.resize(meshopt_encodeIndexSequence(stream.data(), stream.size(), sheet.indices.data(),
                                              sheet.indices.size()));
    return stream;
}

/// Replaces a view's bytes by a stream; the view itself then names buffer 1, which has no bytes.
void compress(WrittenGltf& gltf, int view, const std::vector<unsigned char>& stream, std::size_t stride,
              const char* mode) {
    const int source = gltf.add_view(stream);
    nlohmann::json& views = gltf.json["bufferViews"];
    const std::size_t bytes = views[std::size_t(view)]["byteLength"];
    views[std::size_t(view)] = {{"buffer", 1}, {"byteLength", bytes}};
    views[std::size_t(view)]["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0},
        {"byteOffset", views[std::size_t(source)]["byteOffset"]},
        {"byteLength", stream.size()},
        {"byteStride", stride},
        {"count", bytes / stride},
        {"mode", mode}};
}

WrittenGltf meshopt_gltf(const Sheet& sheet, const std::vector<unsigned char>& vertices,
                         const std::vector<unsigned char>& indices, const char* mode) {
    WrittenGltf gltf;
    gltf.json["extensionsUsed"] = gltf.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    gltf.add_vec3(sheet.positions);
    gltf.primitive()["indices"] = gltf.add_indices(sheet.indices, 5125);
    compress(gltf, 0, vertices, 12, "ATTRIBUTES");
    compress(gltf, 1, indices, 4, mode);
    return gltf;
}

/// Writes it with buffer 1, which is there to be named only.
std::filesystem::path write_with_stand_in(const WrittenGltf& gltf, const TestFolder& folder,
                                          int bytes = 1 << 20) {
    const std::filesystem::path file = gltf.write(folder);
    nlohmann::json whole = nlohmann::json::parse(std::ifstream(file));
    nlohmann::json& stand_in = whole["buffers"].emplace_back();
    stand_in["byteLength"] = bytes;
    stand_in["extensions"]["EXT_meshopt_compression"]["fallback"] = true;
    return folder.write("scene.gltf", whole.dump());
}

TEST(Meshopt, GivesTheSceneThatWasEncodedBitByBit) {
    const TestFolder folder;
    const Sheet sheet(9);
    const Scene plain = plain_scene(folder, sheet);
    const auto sequence = meshopt_gltf(sheet, meshopt_vertices(sheet), meshopt_sequence(sheet), "INDICES");
    EXPECT_EQ(sha256_of(load_gltf_scene(write_with_stand_in(sequence, folder))), sha256_of(plain));
    const auto triangles =
        meshopt_gltf(sheet, meshopt_vertices(sheet), meshopt_triangles(sheet), "TRIANGLES");
    EXPECT_EQ(as_a_set(load_gltf_scene(write_with_stand_in(triangles, folder))), as_a_set(plain));
}

TEST(Meshopt, UndoesItsExponentialFilter) {
    const TestFolder folder;
    const Sheet sheet(3);  // coordinates of few bits: the filter keeps them
    std::vector<float> filtered(sheet.positions.size());
#if MESHOPTIMIZER_VERSION < 200
    meshopt_encodeFilterExp(filtered.data(), sheet.vertices(), 12, 24, sheet.positions.data());
#else
    meshopt_encodeFilterExp(filtered.data(), sheet.vertices(), 12, 24, sheet.positions.data(),
                            meshopt_EncodeExpSharedVector);
#endif
    Sheet other = sheet;
    other.positions = filtered;
    auto gltf = meshopt_gltf(sheet, meshopt_vertices(other), meshopt_sequence(sheet), "INDICES");
    gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "EXPONENTIAL";
    EXPECT_EQ(sha256_of(load_gltf_scene(write_with_stand_in(gltf, folder))),
              sha256_of(plain_scene(folder, sheet)));
}

TEST(Meshopt, RefusesWhatContradictsTheFile) {
    const TestFolder folder;
    const Sheet sheet(3);
    const auto good = meshopt_gltf(sheet, meshopt_vertices(sheet), meshopt_sequence(sheet), "INDICES");
    const auto refusal = [&](const char* key, const nlohmann::json& value) {
        WrittenGltf gltf = good;
        gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        return refusal_of(write_with_stand_in(gltf, folder));
    };
    EXPECT_EQ(refusal("mode", "ATTRIBUTES"), "loaded");
    EXPECT_NE(refusal("count", 17).find("byteStride x count is 204, expected the view's byteLength"),
              std::string::npos);
    EXPECT_NE(refusal("byteLength", 1 << 20).find("meshopt: needs 1048576 bytes at"), std::string::npos);
    EXPECT_NE(refusal("buffer", 1).find("its buffer has 0"), std::string::npos);
    EXPECT_NE(refusal("byteStride", 6).find("a multiple of 4 up to 256"), std::string::npos);
    EXPECT_NE(refusal("mode", "TRIANGLES").find("expected a byteStride of 2 or 4"), std::string::npos);
    EXPECT_NE(refusal("filter", "OCTAHEDRAL").find("byteStride of 4 or 8"), std::string::npos);
    EXPECT_NE(refusal("filter", "COLOR").find("expected one of"), std::string::npos);
    WrittenGltf gltf = good;
    gltf.json["bufferViews"][0].erase("extensions");
    EXPECT_NE(refusal_of(write_with_stand_in(gltf, folder))
                  .find("its buffer has no bytes and it is not compressed"),
              std::string::npos);
}

TEST(Meshopt, RefusesMoreThanItsLimitBeforeItAllocates) {
    const TestFolder folder;
    WrittenGltf gltf =
        meshopt_gltf(Sheet(3), meshopt_vertices(Sheet(3)), meshopt_sequence(Sheet(3)), "INDICES");
    gltf.json["bufferViews"][0]["byteLength"] = 1'200'000'000;
    gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 100'000'000;
    EXPECT_NE(
        refusal_of(write_with_stand_in(gltf, folder, 1'200'000'000)).find("compressed meshes need more than"),
        std::string::npos);
}

TEST(Meshopt, SurvivesStreamsThatAreCutOrChanged) {
    const Sheet sheet(3);
    const auto vertices = meshopt_vertices(sheet), triangles = meshopt_triangles(sheet),
               sequence = meshopt_sequence(sheet);
    const auto unsigned_of = [](const std::vector<char>& s) {
        return std::vector<unsigned char>(s.begin(), s.end());
    };
    expect_no_crash(
        {vertices.begin(), vertices.end()}, [&](const TestFolder& folder, const std::vector<char>& stream) {
            return write_with_stand_in(meshopt_gltf(sheet, unsigned_of(stream), sequence, "INDICES"), folder);
        });
    expect_no_crash({triangles.begin(), triangles.end()}, [&](const TestFolder& folder,
                                                              const std::vector<char>& stream) {
        return write_with_stand_in(meshopt_gltf(sheet, vertices, unsigned_of(stream), "TRIANGLES"), folder);
    });
    expect_no_crash(
        {sequence.begin(), sequence.end()}, [&](const TestFolder& folder, const std::vector<char>& stream) {
            return write_with_stand_in(meshopt_gltf(sheet, vertices, unsigned_of(stream), "INDICES"), folder);
        });
}

}  // namespace
}  // namespace zproof
