/// A triangle's image at many pixels of one view, without doing again what does not change.
#pragma once

#include <optional>

#include "compare/bounds/bounds.h"
#include "compare/bounds/triangle_image.h"

namespace zproof {

/// A triangle's corners in the number type asked for, without loss.
template <class Number>
Corners<Number> corners(const CornersWorld& p) {
    return {exactly<Number>(glm::dvec3(p[0])), exactly<Number>(glm::dvec3(p[1])),
            exactly<Number>(glm::dvec3(p[2]))};
}

/// What a perspective keeps of a triangle's plane: the nearness along a direction of sight is
/// volume_reciprocal * dot(normal, direction).
struct KeptPlane {
    Vector3<double> normal{};
    double volume_reciprocal = 0;
    double gradient = 0;  ///< |d/dx| + |d/dy| of nearness, per px

    double nearness_at(const Vector3<double>& direction) const {
        return volume_reciprocal * dot(normal, direction);
    }
};

/// image_of() in double. For perspective all but the direction of sight is the same at every pixel, so the
/// vectors that it is multiplied with are kept; parallel projections are worked out anew. Either way the
/// bits are those of image_of.
class ImageOfView {
  public:
    /// `any` is the sight of any pixel of the view.
    ImageOfView(const Sight<double>& any, const CornersWorld& p_world);

    /// Is the plane the same at every pixel, but for the direction of sight? For perspectives.
    bool is_kept() const { return is_kept_; }
    /// Does at() give nothing at every pixel? Never said of parallel projections.
    bool is_edge_on() const { return is_edge_on_; }
    /// Nothing where image_of gives nothing.
    std::optional<TriangleImage<double>> at(const Sight<double>& sight) const;
    /// The image's nearness and nothing else.
    std::optional<Affine<double>> nearness(const Sight<double>& sight) const;
    /// At the pixel's centre. Only where at() gives an image.
    double nearness_at(const Sight<double>& sight) const;
    /// The image at `any`; nothing for parallel projections and edge-on triangles.
    std::optional<TriangleImage<double>> at_any() const {
        return is_kept_ && !is_edge_on_ ? std::optional(at_any_) : std::nullopt;
    }
    /// Nothing for parallel projections and edge-on triangles.
    std::optional<KeptPlane> kept_plane() const {
        return is_kept_ && !is_edge_on_ ? std::optional(plane_) : std::nullopt;
    }

  private:
    Corners<double> p_world_;
    bool is_kept_, is_edge_on_ = false;
    std::array<Vector3<double>, 3> moment_{};  ///< of each edge
    KeptPlane plane_;
    int orientation_ = 1;
    TriangleImage<double> at_any_{};
};

}  // namespace zproof
