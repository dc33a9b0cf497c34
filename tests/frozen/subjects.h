/// What is frozen, by group:
///
///     planted   suite views; zproof's frame twice, with wrong answers planted into both
///     moved     suite views; zproof's frame beside the ids that it shows where the view is moved by a
///               fraction of a pixel, with their depths in the view itself
///     random    2 000 small random scenes with random answers, a hundred to a subject
///     suite     suite views; zproof beside Embree
///     selftest  every fault of selftest/ beside Embree
///     opengl    suite views; OpenGL beside Embree
///     povray    suite views of up to 100 000 triangles; POV-Ray beside Embree
///     models    the views of ../shared/models, also those from inside; zproof beside Embree
///
/// Views have 480 x 270 pixels unless said otherwise. The frames of `planted`, `moved` and `random` are the
/// same on every machine, those of the others may differ from processor to processor.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tests/frozen/subject.h"

namespace zproof::frozen {

std::span<const std::string_view> groups();

struct Wanted {
    std::string group;
    std::string name{};  ///< empty: every subject of the group
};

/// Makes the subjects one by one; none where a renderer or a folder is absent. Throws std::invalid_argument
/// for a group that is not.
void each_subject(const Wanted& wanted, const std::function<void(Subject)>& take);

}  // namespace zproof::frozen
