#include "lessons/projection/worked_example.h"

#include <sstream>

#include "lessons/projection/stages.h"
#include "math/rational.h"

namespace zproof::study::projection {

namespace {

constexpr const char *lesson_world = "(-0.315792 1.4489 -2.48901)",
                     *lesson_local = "(-0.500004 0.499998 -0.499997)";

/// Decimals of the lesson, as whole millionths: exact for Rational, rounded once for machine numbers.
template <class Number>
Number millionths(int value) {
    return Number(value) / Number(1'000'000);
}

template <class Number>
Matrix4<Number> world_from_local() {
    const auto q = [](int value) { return millionths<Number>(value); };
    return coordinate_system<Number>({{{q(718762), q(615033), q(-324214)},
                                       {q(-393732), q(744416), q(539277)},
                                       {q(573024), q(-259959), q(777216)}}},
                                     {q(526967), q(1254234), q(-2532150)});
}

template <class Number>
WorkedStep noted(std::string what, std::string numbers, const Vector3<Number>& p, std::string lesson) {
    WorkedStep step{
        std::move(what), std::move(numbers), {double(p.x), double(p.y), double(p.z)}, "", std::move(lesson)};
    std::ostringstream text;  // six significant digits, as the lesson's std::cerr
    text << "(" << step.result[0] << " " << step.result[1] << " " << step.result[2] << ")";
    step.printed = text.str();
    return step;
}

template <class Number>
void work(const std::string& numbers, std::vector<WorkedStep>& steps) {
    const Matrix4<Number> m = world_from_local<Number>();
    const Number half = Number(1) / Number(2);
    const Vector3<Number> local{-half, half, -half}, slip{-half, half, half},
        printed{millionths<Number>(-315792), millionths<Number>(1448900), millionths<Number>(-2489010)};
    steps.push_back(noted("local to world", numbers, local_to_world(m, local), lesson_world));
    steps.push_back(noted("local to world, with z = +0.5 as the text has it once", numbers,
                          local_to_world(m, slip), "(-0.31 1.44 -2.49)"));
    steps.push_back(
        noted("world, as printed, to local", numbers, local_to_world(inverse_of(m), printed), lesson_local));
    steps.push_back(noted("there and back", numbers, local_to_world(inverse_of(m), local_to_world(m, local)),
                          "(-0.5 0.5 -0.5)"));
}

}  // namespace

std::vector<WorkedStep> worked_example() {
    std::vector<WorkedStep> steps;
    work<float>("float32", steps), work<double>("float64", steps), work<Rational>("exact", steps);
    return steps;
}

}  // namespace zproof::study::projection
