/// A fault: one way in which a frame can be wrong, and what the gate must say of it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/judge.h"

namespace zproof::selftest {

/// Where faults are injected: a view, and two frames of it that the gate lets pass. Whoever makes it keeps
/// everything alive.
struct Fixture {
    const Scene& scene;
    const View& view;
    const Frame& good;  ///< the renderer's
    const Frame& reference;
    Precision precision, reference_precision;
};

/// What the gate must answer.
struct Expected {
    enum class Answer {
        fail,    ///< defects
        pass,    ///< no defect: the control that the gate does not cry wolf
        refuse,  ///< no verdict: the frame cannot be held against the view
    };
    Answer answer = Answer::fail;
    std::vector<PixelClass> classes;     ///< each must occur
    std::optional<std::uint64_t> count;  ///< so many pixels have one of the classes, and no other pixel fails
};

/// How large a fixture the fault is for. Judging two million pixels takes a moment, and longer where many are
/// wrong.
enum class FixtureSize { small, large };

/// Whose frame the faulty one takes the place of.
enum class Target { candidate, reference };

/// Whose declared precision the candidate is judged by.
enum class PrecisionSource { of_renderer, of_reference };

struct Fault {
    std::string name;      ///< letters, digits and '_'
    std::string sentence;  ///< what is wrong, for people
    Expected expected;
    std::function<Frame(const Fixture&)> inject;  ///< the faulty frame
    FixtureSize fixture_size = FixtureSize::small;
    Target target = Target::candidate;
    PrecisionSource precision_source = PrecisionSource::of_renderer;
};

/// Every fault, in the order in which they are told.
std::vector<Fault> catalogue();

/// What the gate said of a fault.
struct FaultResult {
    bool as_expected = false;
    std::optional<Verdict> verdict;  ///< none: the gate refused to judge
};

/// Is it a control, a frame that the gate has to let pass?
inline bool is_control(const Fault& fault) { return fault.expected.answer == Expected::Answer::pass; }

/// Injects the fault into the fixture and asks the gate.
FaultResult try_fault(const Fault& fault, const Fixture& fixture);

/// "1 outside", "120 hidden, 31 outside", "no defect", "refused".
std::string in_words(const FaultResult& result);

}  // namespace zproof::selftest
