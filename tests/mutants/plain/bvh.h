/// A tree of boxes over triangles: split at the median, up to 8 triangles in a leaf.
#pragma once

#include "tests/mutants/plain/mesh.h"

namespace plain {

struct Box {
    Vec3<float> low, high;

    static Box empty();
    void add(const Vec3<float>& p);
    void add(const Box& box);
};

struct Triangle {
    std::array<Vec3<float>, 3> corners;
    std::uint32_t id;
};

/// A leaf has triangles; any other node has its children one after the other.
struct Node {
    Box box;
    std::uint32_t first;      ///< triangle, or child
    std::uint32_t count = 0;  ///< of triangles; 0: not a leaf
};

class Bvh {
  public:
    explicit Bvh(const Mesh& mesh);

    std::vector<Triangle> triangles;  ///< in the order of the leaves
    std::vector<Node> nodes;          ///< the root first; none without triangles

  private:
    void build(std::size_t node, std::uint32_t first, std::uint32_t count);
};

}  // namespace plain
