/// What trials of renderers have in common: the suite, the judge, and a line of JSON per view, for
/// tests/mutants/score.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/judge.h"
#include "frame/frame.h"

namespace zproof {

struct TriedRenderer {
    std::function<Frame(const Scene&, const View&)> render;
    Precision precision;
};

/// A frame under test beside its reference.
struct TriedCase {
    const Scene& scene;
    const View& view;
    RenderedFrame candidate, reference;
};

/// How many pixels fail, and in which class.
void add_gate(nlohmann::ordered_json& line, const Verdict& verdict);

/// What the diagnosis names, and which share of the defects it explains; nothing where it names nothing.
void add_cause(nlohmann::ordered_json& line, const TriedCase& tried, const Verdict& verdict);

/// Which rivals raise an alarm.
void add_rivals(nlohmann::ordered_json& line, const Frame& candidate, const Frame& reference);

/// WIDTH HEIGHT FOLDER gate|cause|rivals [VIEW]...: every suite view, or those that are named. gate and cause
/// end at the first defect. FOLDER keeps the references from one call to the next. False where the words are
/// others.
bool try_suite(const std::vector<std::string>& words, const TriedRenderer& renderer);

}  // namespace zproof
