#include "scenes/gltf/bake.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "scenes/refusal.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

/// Differences beyond this are worth a note; nothing else depends on it.
constexpr double worth_a_note = 1e-4;

std::string unique_name(const std::string& wanted, const std::set<std::string>& taken) {
    std::string name = wanted;
    for (int number = 2; taken.contains(name); ++number) name = wanted + "-" + std::to_string(number);
    return name;
}

class CameraBaker {
  public:
    CameraBaker(const GltfModel& model, const glm::ivec2& size, Loaded& loaded)
        : model_(model), size_(size), loaded_(loaded) {
        for (const View& view : loaded.views) names_.insert(view.name);
    }

    void bake(const PlacedNode& placed) {
        const gltf::Node& node = at(model_.document.nodes, placed.node);
        if (node.camera < 0) return;
        const gltf::Camera& intrinsics = at(model_.document.cameras, node.camera);
        name_ = unique_name(view_name(node.name.empty() ? intrinsics.name : node.name), names_);
        Camera camera;
        place(placed, camera);
        intrinsics.type == "perspective" ? set_perspective(intrinsics.perspective, camera)
                                         : set_orthographic(intrinsics.orthographic, camera);
        validate(camera);
        names_.insert(name_);
        loaded_.views.push_back({name_, camera, size_.x, size_.y});
    }

  private:
    double aspect() const { return static_cast<double>(size_.x) / size_.y; }

    void note(const std::string& kind, const std::string& more = "") {
        loaded_.scene.notes.push_back(kind + ": " + name_ + more);
    }

    /// Gram-Schmidt from the view axis, twice: the second round removes what the first one's rounding left.
    void place(const PlacedNode& placed, Camera& camera) {
        const glm::dmat4& world = placed.world_from_node;
        camera.eye_world = glm::vec3(glm::dvec3(world[3]));
        glm::dvec3 right(world[0]), up(world[1]), back(world[2]);
        // The volume of the axes' box; not a number where an axis has no length. Below 1e-9 Gram-Schmidt has
        // no digits left.
        const double volume =
            glm::dot(glm::cross(glm::normalize(right), glm::normalize(up)), glm::normalize(back));
        if (!(std::abs(volume) > 1e-9))
            refuse(model_.file, "/nodes/" + std::to_string(placed.node),
                   "the camera's axes are not independent; expected a node without a scale of 0");
        note_distortion(right, up, back);
        if (glm::dot(glm::cross(right, up), back) < 0) right = -right;
        for (int round = 0; round < 2; ++round) {
            back = glm::normalize(back);
            right = glm::normalize(right - glm::dot(right, back) * back);
            up = glm::normalize(glm::cross(back, right));
        }
        camera.right = right;
        camera.up = up;
        camera.back = back;
    }

    void note_distortion(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& back) {
        double off = 0;
        for (const glm::dvec3& axis : {right, up, back}) off = std::max(off, std::abs(glm::length(axis) - 1));
        for (const double product : {glm::dot(right, up), glm::dot(up, back), glm::dot(back, right)})
            off = std::max(off, std::abs(product));
        if (off > worth_a_note) note("scale and shear of a camera's node dropped");
        if (glm::dot(glm::cross(right, up), back) < 0) note("mirroring by a camera's node dropped");
    }

    void note_aspect(double declared) {
        if (std::abs(declared / aspect() - 1) > worth_a_note)
            note("a camera's aspect replaced by the image's",
                 ", " + std::to_string(declared) + " by " + std::to_string(aspect()));
    }

    void set_perspective(const gltf::Perspective& intrinsics, Camera& camera) {
        camera.projection = Projection::perspective;
        camera.window = symmetric_window(intrinsics.yfov, aspect());
        camera.near_depth = intrinsics.znear;
        camera.far_depth = intrinsics.zfar > 0 ? intrinsics.zfar : std::numeric_limits<double>::infinity();
        if (intrinsics.aspectRatio > 0) note_aspect(intrinsics.aspectRatio);
    }

    void set_orthographic(const gltf::Orthographic& intrinsics, Camera& camera) {
        camera.projection = Projection::parallel;
        const double half_width = intrinsics.ymag * aspect();
        camera.window = {-half_width, half_width, -intrinsics.ymag, intrinsics.ymag};
        camera.near_depth = intrinsics.znear;
        camera.far_depth = intrinsics.zfar;
        note_aspect(intrinsics.xmag / intrinsics.ymag);
    }

    const GltfModel& model_;
    glm::ivec2 size_;
    Loaded& loaded_;
    std::set<std::string> names_;
    std::string name_;
};

}  // namespace

void bake_cameras(const GltfModel& model, const std::vector<PlacedNode>& nodes, const glm::ivec2& size,
                  Loaded& loaded) {
    CameraBaker baker(model, size, loaded);
    for (const PlacedNode& placed : nodes) baker.bake(placed);
}

}  // namespace zproof
