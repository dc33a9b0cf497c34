/// Measures a renderer, and holds what it does against what it declares.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measure/measurement.h"
#include "measure/renderer.h"

namespace zproof::measure {

/// Receives the progress of a measurement, and may stop it.
struct ProgressSink {
    /// An instrument begins: "fill side", and about how many pictures it takes.
    std::function<void(const std::string& what, int pictures)> begins = [](const std::string&, int) {};
    std::function<void()> ends = [] {};                          ///< it has read what it can
    std::function<bool()> wants_to_stop = [] { return false; };  ///< asked before every picture
};

inline constexpr int instrument_count = 7, about_all_pictures = 211;  ///< of a whole measurement

/// Draws the probe scenes, some 210 pictures of at most 16384 pixels, and reads them. What they do not tell
/// stands in Measurement::unmeasured; what the renderer throws is passed on. Where the progress sink wants to
/// stop, what the instruments before found is all that is found.
Measurement measure(const Renderer& renderer, const ProgressSink& progress = {});

enum class Conformity {
    as_declared,  ///< as good as declared, or better
    worse,        ///< for certain: the whole bracket lies outside of what is declared
    undeclared,   ///< nothing was promised
};

/// One measured thing, ready to be shown.
struct Finding {
    std::string name;              ///< lower case, '_': "subpixel_bits_x"
    std::string title;             ///< for people: "sub-pixel bits, x"
    std::optional<Bracket> value;  ///< where it is a number
    std::string unit;              ///< of the value; may be empty
    std::string words;             ///< what was measured, where a number does not say it all
    std::string declared;          ///< empty where nothing was promised
    Conformity conformity = Conformity::undeclared;
};

/// Every measured thing in a fixed order, judged by docs/bounds.md. What could not be measured is worse than
/// declared.
std::vector<Finding> findings(const Measurement& measurement, const Precision& declared);

bool is_worse(std::span<const Finding> findings);  ///< in any of them

}  // namespace zproof::measure
