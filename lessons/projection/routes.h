/// Ways from world to raster space, each a list of named operations that can be stopped, replaced and
/// repeated exactly: an instrument finds out where a pixel is lost, and whether a route is the projection at
/// all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lessons/projection/camera.h"

namespace zproof::study::projection {

enum class Space {
    camera,
    clip,           ///< homogeneous, w = camera depth (parallel: 1)
    screen,         ///< on the near plane (parallel: on the plane through the eye)
    screen_at_one,  ///< on the plane at camera depth 1
    ndc,            ///< [-1, 1], y up
    unit_ndc,       ///< [0, 1], y up
    raster,
};

/// "camera", "clip", "screen", "NDC [-1, 1]", ...
std::string in_words(Space space);

/// A point on its way.
template <class Number>
struct Travel {
    Point4<Number> at;        ///< homogeneous; w is 1 but in clip space
    Point2<Number> screen{};  ///< where it was in screen space; some slips go back to it
};

template <class Number>
struct Operation {
    std::string stage, name;       ///< "screen to NDC", "2 x / (r - l)"
    std::optional<Space> arrives;  ///< the operation ends its stage in this space
    std::function<Travel<Number>(const Travel<Number>&)> apply;
};

/// What a route is for.
enum class RouteKind {
    lesson,
    slip,  ///< printed in a lesson, and wrong
};

struct RouteCard {
    std::string name, words, source;
    RouteKind kind = RouteKind::lesson;
};

template <class Number>
struct Route {
    RouteCard card;
    std::vector<Operation<Number>> operations;
};

/// The routes that exist for this kind of camera, the same ones in the same order for every number type. The
/// canvas of width W and height H is about the axis by definition: it exists for perspective cameras whose
/// window is.
template <class Number>
std::vector<Route<Number>> routes(const NumericCamera<Number>& camera);

extern template std::vector<Route<float>> routes(const NumericCamera<float>& camera);
extern template std::vector<Route<double>> routes(const NumericCamera<double>& camera);
extern template std::vector<Route<Rational>> routes(const NumericCamera<Rational>& camera);

template <class Number>
Travel<Number> departure(const Vector3<Number>& p_world) {
    return {{p_world.x, p_world.y, p_world.z, Number(1)}, {}};
}

/// The result of the operations from this index to the end.
template <class Number>
Travel<Number> arrival(const Route<Number>& route, Travel<Number> travel, std::size_t from = 0) {
    for (std::size_t i = from; i < route.operations.size(); ++i) travel = route.operations[i].apply(travel);
    return travel;
}

}  // namespace zproof::study::projection
