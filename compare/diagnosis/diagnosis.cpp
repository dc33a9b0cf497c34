#include "compare/diagnosis/diagnosis.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypothesis_check.h"

namespace zproof {

namespace {

constexpr std::size_t first_round = 128, second_round = 1000;  ///< claims of either kind per hypothesis
constexpr std::size_t most_runners_up = 3;

/// A number in [0, 1) that looks random (SplitMix64, Steele, Lea and Flood 2014).
double scattered(std::uint64_t k) {
    std::uint64_t z = (k + 1) * 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9u;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// One of every `total / most` in a row, at a scattered place, so that no stride meets the image's columns.
std::vector<std::size_t> spread(std::size_t total, std::size_t most) {
    const std::size_t count = std::min(total, most);
    std::vector<std::size_t> chosen(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double place = double(k) + (count < total ? scattered(k) : 0.0);
        chosen[k] = std::min(total - 1, std::size_t(place * double(total) / double(count)));
    }
    return chosen;
}

/// The pixels that agree in those cells of a grid that hold a defect.
std::vector<std::uint32_t> agreeing_beside_defects(const Verdict& verdict, Resolution cell) {
    const Resolution size = verdict.classes.size();
    const auto place = [&](int x, int y) { return std::pair{x / cell.width, y / cell.height}; };
    const auto [right, lowest] = place(size.width - 1, size.height - 1);
    Plane<std::uint8_t> holds_defect({right + 1, lowest + 1});
    for (const Finding& f : verdict.findings) {
        const auto [column, row] = place(f.x, f.y);
        if (is_defect(f.verdict)) holds_defect.at(column, row) = 1;
    }
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto [column, row] = place(x, y);
            if (verdict.classes.at(x, y) == PixelClass::agree && holds_defect.at(column, row))
                pixels.push_back(std::uint32_t(y) * std::uint32_t(size.width) + std::uint32_t(x));
        }
    return pixels;
}

/// What a hypothesis must explain, and what it must not break.
class DefectSet {
  public:
    DefectSet(const Frame& candidate, const Verdict& verdict) : candidate_(candidate), verdict_(verdict) {
        for (const Finding& f : verdict.findings)
            if (is_defect(f.verdict) && f.verdict != PixelClass::wrong_attribute) {
                defects_.push_back({f.x, f.y, f.candidate});
                are_all_depths_ &= f.verdict == PixelClass::wrong_depth;
            }
    }

    std::size_t defect_count() const { return defects_.size(); }
    bool are_all_depths() const { return are_all_depths_; }
    std::vector<Claim> defects(std::size_t most) const {
        std::vector<Claim> claims;
        for (const std::size_t i : spread(defects_.size(), most)) claims.push_back(defects_[i]);
        return claims;
    }

    std::size_t agreeing_count(Resolution cell) { return agreeing_beside(cell).size(); }
    std::vector<Claim> agreeing(Resolution cell, std::size_t most) {
        const std::vector<std::uint32_t>& pixels = agreeing_beside(cell);
        std::vector<Claim> claims;
        for (const std::size_t i : spread(pixels.size(), most)) claims.push_back(claim_at(pixels[i]));
        return claims;
    }

  private:
    const std::vector<std::uint32_t>& agreeing_beside(Resolution cell) {
        const auto [entry, is_new] = agreeing_.try_emplace({cell.width, cell.height});
        if (is_new) entry->second = agreeing_beside_defects(verdict_, cell);
        return entry->second;
    }
    Claim claim_at(std::uint32_t pixel) const {
        const auto width = std::uint32_t(candidate_.size().width);
        const int x = int(pixel % width), y = int(pixel / width);
        return {x, y, {candidate_.primitive.at(x, y), candidate_.camera_depth.at(x, y)}};
    }

    const Frame& candidate_;
    const Verdict& verdict_;
    std::vector<Claim> defects_;
    bool are_all_depths_ = true;
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> agreeing_;  ///< by width and height of the cell
};

struct HypothesisTest {
    const Hypothesis* hypothesis = nullptr;
    std::size_t place = 0;  ///< in the order of all hypotheses
    Explanation outcome;
    double gain = 0;  ///< share of the defects that would vanish, less those that would appear
    double widening = 0;
};

bool explains_most(const HypothesisTest& test) { return test.gain > 0.5; }

/// The better first. Of equals, the narrowest, and then the more specific, which stood first.
void rank(std::vector<HypothesisTest>& tests) {
    std::ranges::sort(tests, {}, [](const HypothesisTest& t) {
        return std::tuple{-t.gain, t.widening, t.place};
    });
}

class Diagnoser {
  public:
    Diagnoser(const DiagnosisInput& input, const Verdict& verdict)
        : input_(input), defect_set_(input.candidate.frame, verdict), hypotheses_(all_hypotheses(input)) {}

    Diagnosis run() {
        std::vector<HypothesisTest> done;
        for (const Kind kind : {Kind::firm, Kind::widening_only, Kind::fitted}) {
            std::vector<HypothesisTest> tests = tests_of(kind);
            kind == Kind::widening_only ? run_widening(tests) : run(tests);
            done.insert(done.end(), tests.begin(), tests.end());
            rank(done);
            if (!done.empty() && explains_most(done.front())) break;
        }
        return diagnosis_from(done);
    }

  private:
    /// One wrong pixel proves no rule that would show all over the frame. What moves triangles shows at
    /// edges.
    bool may_apply(const Hypothesis& h) const {
        if (h.moves_triangles && defect_set_.are_all_depths()) return false;
        return defect_set_.defect_count() > 1 ||
               (h.kind == Kind::firm && h.cell != input_.candidate.frame.size());
    }

    std::vector<HypothesisTest> tests_of(Kind kind) const {
        std::vector<HypothesisTest> tests;
        for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
            const Hypothesis& h = hypotheses_[i];
            if (h.kind == kind && may_apply(h))
                tests.push_back({&h, i, {.name = h.name, .description = h.description}});
        }
        return tests;
    }

    /// A second, larger round for those that explain most; for the first alone where it leaves nothing to
    /// explain.
    void run(std::vector<HypothesisTest>& tests) {
        ask(tests, first_round);
        rank(tests);
        const auto rest = std::ranges::partition_point(tests, explains_most);
        const std::span likely(tests.begin(), rest);
        if (likely.empty()) return;
        ask(likely.first(1), second_round);
        if (likely.front().gain < 1) ask(likely.subspan(1), second_round);
    }

    /// One at a time, the narrowest first: behind one that leaves nothing to explain, wider ones have no say.
    void run_widening(std::vector<HypothesisTest>& tests) {
        const std::vector<Claim> defects = defect_set_.defects(first_round);
        for (HypothesisTest& t : tests) t.widening = mean_widening(input_, {t.hypothesis, defects});
        std::ranges::stable_sort(tests, {}, &HypothesisTest::widening);
        for (std::size_t i = 0; i < tests.size(); ++i) {
            const std::span one = std::span(tests).subspan(i, 1);
            ask(one, first_round);
            if (tests[i].gain == 1) ask(one, second_round);
            if (tests[i].gain == 1) tests.resize(i + 1);
        }
        rank(tests);
        if (!tests.empty() && explains_most(tests.front())) ask(std::span(tests).first(1), second_round);
    }

    /// Puts up to `most` defects, and as many agreeing pixels, to every test's hypothesis.
    void ask(std::span<HypothesisTest> tests, std::size_t most) {
        const std::vector<Claim> defects = defect_set_.defects(most);
        std::vector<std::vector<Claim>> agreeing;
        for (const HypothesisTest& t : tests)
            agreeing.push_back(defect_set_.agreeing(t.hypothesis->cell, most));
        std::vector<HypothesisQuery> queries;
        for (std::size_t i = 0; i < tests.size(); ++i) {
            queries.push_back({tests[i].hypothesis, defects});
            queries.push_back({tests[i].hypothesis, agreeing[i]});
        }
        const std::vector<std::uint64_t> admissible = count_admissible(input_, queries);
        for (std::size_t i = 0; i < tests.size(); ++i) {
            Explanation& e = tests[i].outcome;
            e.explained = admissible[2 * i];
            e.asked = defects.size();
            e.contradicted = agreeing[i].size() - admissible[2 * i + 1];
            e.checked = agreeing[i].size();
            tests[i].gain = gain_of(tests[i]);
        }
    }

    double gain_of(const HypothesisTest& test) {
        const Explanation& e = test.outcome;
        if (e.contradicted == 0) return explained_share(e);
        const double agreeing = double(defect_set_.agreeing_count(test.hypothesis->cell));
        const double appearing = double(e.contradicted) / double(e.checked) * agreeing;
        return explained_share(e) - appearing / double(defect_set_.defect_count());
    }

    Diagnosis diagnosis_from(std::span<const HypothesisTest> ranked) const {
        Diagnosis diagnosis{.defects = defect_set_.defect_count(), .cause = std::nullopt, .runners_up = {}};
        for (const HypothesisTest& test : ranked) {
            if (&test == &ranked.front() && explains_most(test))
                diagnosis.cause = test.outcome;
            else if (test.gain > 0 && diagnosis.runners_up.size() < most_runners_up)
                diagnosis.runners_up.push_back(test.outcome);
        }
        return diagnosis;
    }

    const DiagnosisInput& input_;
    DefectSet defect_set_;
    std::vector<Hypothesis> hypotheses_;
};

}  // namespace

double explained_share(const Explanation& e) {
    return e.asked == 0 ? 0 : double(e.explained) / double(e.asked);
}

std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict) {
    if (defect_count(verdict) == verdict.counts[std::size_t(PixelClass::wrong_attribute)])
        return std::nullopt;
    if (scene.triangles.empty())  // there is nothing to draw wrongly
        return Diagnosis{.defects = defect_count(verdict), .cause = std::nullopt, .runners_up = {}};
    const DiagnosisInput input{scene, view, candidate, reference};
    return Diagnoser(input, verdict).run();
}

}  // namespace zproof
