#include "scenes/scene_hash.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zproof {
namespace {

Scene square() {
    Scene scene;
    scene.vertices.position_world = {{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}};
    scene.triangles = {{0, 1, 2}, {0, 2, 3}};
    return scene;
}

TEST(SceneHash, HasSixtyFourDigits) {
    const std::string hash = sha256_of(square());
    EXPECT_EQ(hash.size(), 64u);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
}

// Written down from the bytes that scene_hash.h names (python3 -c "hashlib.sha256(...)").
TEST(SceneHash, IsWhatItsHeaderSays) {
    Scene scene;
    scene.vertices.position_world = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.triangles = {{0, 1, 2}};
    EXPECT_EQ(sha256_of(scene), "213ff1acda52f04754096e6fdcece0b07e75cb6f21a9d9fc4b234a6a08c98f1e");
}

TEST(SceneHash, ChangesWithEveryBitOfTheGeometry) {
    const std::string before = sha256_of(square());
    Scene moved = square(), signed_zero = square(), swapped = square(), fewer = square();
    moved.vertices.position_world[2].y = std::nextafter(1.0f, 2.0f);
    signed_zero.vertices.position_world[0].x = -0.0f;
    std::swap(swapped.triangles[0], swapped.triangles[1]);
    fewer.triangles.pop_back();
    for (const Scene* other : {&moved, &signed_zero, &swapped, &fewer}) EXPECT_NE(sha256_of(*other), before);
}

TEST(SceneHash, DoesNotMistakeAVertexForATriangle) {
    Scene vertices, triangles;
    vertices.vertices.position_world = {{0, 0, 0}, {0, 0, 0}};
    triangles.vertices.position_world = {{0, 0, 0}};
    triangles.triangles = {{0, 0, 0}};
    EXPECT_NE(sha256_of(vertices), sha256_of(triangles));
}

TEST(SceneHash, LeavesOutWhatHasNoSayInWhichTriangleIsSeen) {
    Scene renamed = square();
    renamed.name = "other";
    renamed.notes = {"a note"};
    renamed.materials.resize(3);
    renamed.vertices.normal_world.assign(4, glm::vec3(0));
    EXPECT_EQ(sha256_of(renamed), sha256_of(square()));
}

}  // namespace
}  // namespace zproof
