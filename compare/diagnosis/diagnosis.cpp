#include "compare/diagnosis/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypothesis_check.h"

namespace zproof {

namespace {

constexpr std::size_t first_round = 128, second_round = 1000;  ///< claims of either kind per hypothesis
constexpr std::size_t at_a_time = 4;
constexpr std::size_t most_causes = 3;
constexpr std::size_t most_looked_at = 20'000;  ///< defects that the next cause is sought among
constexpr double least_saved_share = 0.75;  ///< of causes that are named (docs/diagnosis.md, "Calibration")
constexpr double least_part = 0.05;         ///< of what the defects take: what a further cause must spare
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

/// The cells of a grid over the view, and those that hold a defect.
class CellGrid {
  public:
    CellGrid(const Verdict& verdict, Resolution cell)
        : verdict_(verdict),
          cell_(cell),
          holds_defect_({cells_along(verdict.classes.size().width, cell.width),
                         cells_along(verdict.classes.size().height, cell.height)}) {
        for (const Finding& f : verdict.findings)
            if (is_defect(f.verdict)) holds_defect_.at(f.x / cell.width, f.y / cell.height) = 1;
    }

    double count() const { return double(holds_defect_.pixels().size()); }
    double with_defects() const { return double(std::ranges::count(holds_defect_.pixels(), 1)); }
    /// The pixels that agree in cells that hold a defect.
    std::vector<std::uint32_t> agreeing() const {
        const Resolution size = verdict_.classes.size();
        std::vector<std::uint32_t> pixels;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (verdict_.classes.at(x, y) == PixelClass::agree &&
                    holds_defect_.at(x / cell_.width, y / cell_.height))
                    pixels.push_back(std::uint32_t(y) * std::uint32_t(size.width) + std::uint32_t(x));
        return pixels;
    }

  private:
    static int cells_along(int side, int cell) { return (side + cell - 1) / cell; }

    const Verdict& verdict_;
    Resolution cell_;
    Plane<std::uint8_t> holds_defect_;
};

/// Claims. Each stands for `weight` of the view's pixels.
struct Sample {
    std::vector<Claim> claims;
    std::vector<double> weights;

    void add(std::span<const Claim> some, double of_pixels) {
        claims.insert(claims.end(), some.begin(), some.end());
        weights.insert(weights.end(), some.size(), of_pixels / double(some.size()));
    }
};

/// What a hypothesis must explain, and what it must not break.
class DefectSet {
  public:
    DefectSet(const Frame& candidate, const Verdict& verdict) : candidate_(candidate), verdict_(verdict) {
        for (const Finding& f : verdict.findings)
            if (is_defect(f.verdict) && f.verdict != PixelClass::wrong_attribute)
                defects_.push_back({f.x, f.y, f.candidate});
    }

    std::size_t defect_count() const { return defects_.size(); }
    bool are_all_depths() const {
        return std::ranges::all_of(defects_, [&](const Claim& claim) {
            return verdict_.classes.at(claim.x, claim.y) == PixelClass::wrong_depth;
        });
    }
    /// All of them, or an evenly spread part where they are very many.
    std::vector<Claim> many() const { return defects(most_looked_at).claims; }
    /// Keeps those alone that a hypothesis left: some of many().
    void keep(std::vector<Claim> left) {
        pixels_each_ *= double(defects_.size()) / double(std::min(defects_.size(), most_looked_at));
        defects_ = std::move(left);
    }
    double pixel_count() const { return pixels_each_ * double(defects_.size()); }
    Sample defects(std::size_t most) const {
        std::vector<Claim> claims;
        for (const std::size_t i : spread(defects_.size(), most)) claims.push_back(defects_[i]);
        Sample sample;
        sample.add(claims, pixel_count());
        return sample;
    }

    /// Half of them where the candidate's id changes, as there are any: that is where much is left open.
    Sample agreeing(Resolution cell, std::size_t most) {
        const Agreeing& all = agreeing_beside(cell);
        Sample sample;
        for (const std::vector<std::uint32_t>* part : {&all.at_edges, &all.elsewhere}) {
            std::vector<Claim> claims;
            for (const std::size_t i : spread(part->size(), most / 2)) claims.push_back(claim_at((*part)[i]));
            sample.add(claims, double(part->size()));
        }
        return sample;
    }

    /// Of a grid of such cells.
    struct Cells {
        double with_defects = 0, all = 0;
    };
    Cells cells(Resolution cell) { return agreeing_beside(cell).cells; }

  private:
    struct Agreeing {
        std::vector<std::uint32_t> at_edges, elsewhere;
        Cells cells;
    };

    const Agreeing& agreeing_beside(Resolution cell) {
        const auto [entry, is_new] = agreeing_.try_emplace({cell.width, cell.height});
        if (!is_new) return entry->second;
        const CellGrid grid(verdict_, cell);
        for (const std::uint32_t pixel : grid.agreeing())
            (is_at_edge(pixel) ? entry->second.at_edges : entry->second.elsewhere).push_back(pixel);
        entry->second.cells = {grid.with_defects(), grid.count()};
        return entry->second;
    }
    PixelCoord place_of(std::uint32_t pixel) const {
        const auto width = std::uint32_t(candidate_.size().width);
        return {int(pixel % width), int(pixel / width)};
    }
    Claim claim_at(std::uint32_t pixel) const {
        const auto [x, y] = place_of(pixel);
        return {x, y, {candidate_.primitive.at(x, y), candidate_.camera_depth.at(x, y)}};
    }
    bool is_at_edge(std::uint32_t pixel) const {
        const auto [x, y] = place_of(pixel);
        const Resolution size = candidate_.size();
        const PrimitiveId own = candidate_.primitive.at(x, y);
        return (x > 0 && candidate_.primitive.at(x - 1, y) != own) ||
               (y > 0 && candidate_.primitive.at(x, y - 1) != own) ||
               (x + 1 < size.width && candidate_.primitive.at(x + 1, y) != own) ||
               (y + 1 < size.height && candidate_.primitive.at(x, y + 1) != own);
    }

    const Frame& candidate_;
    const Verdict& verdict_;
    std::vector<Claim> defects_;
    double pixels_each_ = 1;                            ///< that a defect stands for
    std::map<std::pair<int, int>, Agreeing> agreeing_;  ///< by width and height of the cell
};

struct HypothesisTest {
    const Hypothesis* hypothesis = nullptr;
    std::size_t place = 0;  ///< in the order of all hypotheses
    Explanation outcome;
    double saved_bits = 0;  ///< by which the frame is told shorter
};

/// The better first. Of equals, the more specific, which stood first.
void rank(std::span<HypothesisTest> tests) {
    std::ranges::sort(tests, {}, [](const HypothesisTest& t) { return std::pair{-t.saved_bits, t.place}; });
}

/// log2 of the ways to choose some of many: what it takes to tell which they are.
double bits_of_choice(double some, double all) {
    if (some <= 0 || some >= all) return 0;
    const double share = some / all;
    return -all * (share * std::log2(share) + (1 - share) * std::log2(1 - share));
}

/// The length of a description of the frame: how a hypothesis is scored (docs/diagnosis.md, "The score").
class Description {
  public:
    Description(const Scene& scene, Resolution size, std::size_t hypotheses)
        : bits_of_answer_(bits_of_an_id(scene) + 32),
          pixels_(double(size.pixel_count())),
          bits_of_name_(std::log2(double(hypotheses))) {}

    /// Of pixels whose answers nothing predicts: which they are, and what they say.
    double of_exceptions(double count) const {
        return bits_of_choice(count, pixels_) + count * bits_of_answer_;
    }
    double of_name() const { return bits_of_name_; }

  private:
    double bits_of_answer_, pixels_, bits_of_name_;
};

class Diagnoser {
  public:
    Diagnoser(const DiagnosisInput& input, const Verdict& verdict, std::span<const std::string> without)
        : input_(input),
          defect_set_(input.candidate.frame, verdict),
          hypotheses_(all_hypotheses(input)),
          declared_(as_declared(input, "", "")),
          description_(input.scene, input.candidate.frame.size(), hypotheses_.size()) {
        std::erase_if(hypotheses_,
                      [&](const Hypothesis& h) { return std::ranges::count(without, h.name) > 0; });
        open_bits_of_right_pixel_ = open_bits_of_right_pixel();
    }

    Diagnosis run() {
        const std::vector<HypothesisTest> first = best_tests();
        Diagnosis diagnosis = without_cause(first);
        const double all_bits = bits_of_defects();
        double saved_bits = 0;
        std::vector<Explanation> causes;
        for (std::vector<HypothesisTest> best = first; !best.empty(); best = best_tests()) {
            if (best.front().saved_bits < least_part * all_bits) break;
            saved_bits += best.front().saved_bits;
            causes.push_back(best.front().outcome);
            if (causes.size() == most_causes) break;
            defect_set_.keep(left_by(*best.front().hypothesis));
        }
        if (saved_bits >= least_saved_share * all_bits) name(causes, first, diagnosis);
        return diagnosis;
    }

  private:
    /// One wrong pixel proves no rule that would show all over the frame. What moves triangles shows at
    /// edges.
    bool may_apply(const Hypothesis& h) const {
        if (h.moves_triangles && defect_set_.are_all_depths()) return false;
        return defect_set_.defect_count() > 1 || h.cell != input_.candidate.frame.size();
    }

    std::vector<HypothesisTest> all_tests() const {
        std::vector<HypothesisTest> tests;
        for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
            const Hypothesis& h = hypotheses_[i];
            if (may_apply(h))
                tests.push_back(
                    {&h, i, {.name = h.name, .description = h.description, .look_at = h.look_at}});
        }
        return tests;
    }

    /// The best, ranked; those alone that save anything.
    std::vector<HypothesisTest> best_tests() {
        if (defect_set_.defect_count() == 0) return {};
        std::vector<HypothesisTest> tests = all_tests();
        ask(tests, first_round, CheckDetail::admissibility);
        rank(tests);
        tests.resize(with_open_bits(tests));
        ask(tests, second_round, CheckDetail::open_bits);
        rank(tests);
        std::erase_if(tests, [](const HypothesisTest& t) { return t.saved_bits <= 0; });
        put_unlearned_first(tests);
        return tests;
    }

    /// Of those that are as good as the best, the ones that learned nothing from the frames stand first.
    void put_unlearned_first(std::vector<HypothesisTest>& ranked) const {
        if (ranked.empty()) return;
        const double least = ranked.front().outcome.saved_share - alike_shares;
        const auto alike = std::ranges::partition_point(
            ranked, [&](const HypothesisTest& t) { return t.outcome.saved_share > least; });
        const Resolution whole = input_.candidate.frame.size();
        std::stable_partition(ranked.begin(), alike, [&](const HypothesisTest& t) {
            return t.hypothesis->learned_bits == 0 && t.hypothesis->cell == whole;
        });
    }

    /// Counts what those that save the most leave open, a few at a time, and ranks them anew; how many of
    /// them are worth a larger sample. What is left open makes a description longer: the rest cannot save
    /// more than they seemed to.
    std::size_t with_open_bits(std::span<HypothesisTest> ranked) {
        std::size_t asked = 0;
        double most_saved = 0;
        while (asked < ranked.size() && ranked[asked].saved_bits > most_saved) {
            const std::span next = ranked.subspan(asked, std::min(at_a_time, ranked.size() - asked));
            ask(next, first_round, CheckDetail::open_bits);
            for (const HypothesisTest& t : next) most_saved = std::max(most_saved, t.saved_bits);
            asked += next.size();
        }
        rank(ranked.first(asked));
        return std::min(asked, most_runners_up + 1);
    }

    /// Puts up to `most` defects, and as many agreeing pixels, to every test's hypothesis.
    void ask(std::span<HypothesisTest> tests, std::size_t most, CheckDetail detail) {
        const Sample defects = defect_set_.defects(most);
        std::vector<Sample> agreeing;
        for (const HypothesisTest& t : tests)
            agreeing.push_back(defect_set_.agreeing(t.hypothesis->cell, most));
        std::vector<HypothesisQuery> queries;
        for (std::size_t i = 0; i < tests.size(); ++i) {
            queries.push_back({tests[i].hypothesis, defects.claims});
            queries.push_back({tests[i].hypothesis, agreeing[i].claims});
            queries.push_back({&declared_, agreeing[i].claims});
        }
        const std::vector<std::vector<ClaimCheck>> checks = check_claims(input_, queries, detail);
        for (std::size_t i = 0; i < tests.size(); ++i)
            tell(tests[i], {defects, checks[3 * i]}, {agreeing[i], checks[3 * i + 1]},
                 {agreeing[i], checks[3 * i + 2]});
    }

    struct Checked {
        const Sample& sample;
        std::span<const ClaimCheck> checks;

        std::uint64_t admissible() const {
            return std::uint64_t(std::ranges::count_if(checks, &ClaimCheck::is_admissible));
        }
        double exceptions() const {
            double sum = 0;
            for (std::size_t i = 0; i < checks.size(); ++i)
                if (!checks[i].is_admissible) sum += sample.weights[i];
            return sum;
        }
        double open_bits() const {
            double sum = 0;
            for (std::size_t i = 0; i < checks.size(); ++i) sum += sample.weights[i] * checks[i].open_bits;
            return sum;
        }
    };

    /// What the hypothesis explains and breaks, and how much shorter the frame is told with it.
    void tell(HypothesisTest& test, const Checked& defects, const Checked& agreeing,
              const Checked& agreeing_as_declared) {
        const Hypothesis& h = *test.hypothesis;
        Explanation& e = test.outcome;
        e.explained = defects.admissible();
        e.asked = defects.checks.size();
        e.contradicted = agreeing.checks.size() - agreeing.admissible();
        e.checked = agreeing.checks.size();
        const auto [with_defects, all_cells] = defect_set_.cells(h.cell);
        const double told_with =
            description_.of_name() + h.learned_bits + bits_of_choice(with_defects, all_cells) +
            description_.of_exceptions(defects.exceptions() + agreeing.exceptions()) + defects.open_bits() +
            agreeing.open_bits() - agreeing_as_declared.open_bits();
        test.saved_bits = description_.of_exceptions(defect_set_.pixel_count()) - told_with;
        e.saved_share = std::min(1.0, test.saved_bits / bits_of_defects());
    }

    /// What a description can spare at most: all that the defects take but what a right pixel leaves open.
    double bits_of_defects() const {
        return description_.of_exceptions(defect_set_.pixel_count()) -
               defect_set_.pixel_count() * open_bits_of_right_pixel_;
    }

    /// The mean over the defects, by the reference's answers there.
    double open_bits_of_right_pixel() {
        std::vector<Claim> claims = defect_set_.defects(first_round).claims;
        const Frame& reference = input_.reference.frame;
        for (Claim& claim : claims)
            claim.answer = {reference.primitive.at(claim.x, claim.y),
                            reference.camera_depth.at(claim.x, claim.y)};
        const HypothesisQuery query{&declared_, claims};
        const auto checks = check_claims(input_, {&query, 1}, CheckDetail::open_bits);
        double sum = 0;
        for (const ClaimCheck& check : checks.front()) sum += check.open_bits;
        return sum / double(claims.size());
    }

    /// The defects that a hypothesis does not explain.
    std::vector<Claim> left_by(const Hypothesis& hypothesis) const {
        const std::vector<Claim> claims = defect_set_.many();
        const HypothesisQuery query{&hypothesis, claims};
        const std::vector<std::vector<ClaimCheck>> checks =
            check_claims(input_, {&query, 1}, CheckDetail::admissibility);
        std::vector<Claim> left;
        for (std::size_t i = 0; i < claims.size(); ++i)
            if (!checks.front()[i].is_admissible) left.push_back(claims[i]);
        return left;
    }

    /// As it stands where no cause is named.
    Diagnosis without_cause(const std::vector<HypothesisTest>& best) const {
        Diagnosis diagnosis{
            .defects = defect_set_.defect_count(), .cause = {}, .further = {}, .runners_up = {}};
        for (const HypothesisTest& test : std::span(best).first(std::min(best.size(), most_runners_up)))
            diagnosis.runners_up.push_back(test.outcome);
        return diagnosis;
    }

    /// Names the best first, and its runners-up.
    static void name(const std::vector<Explanation>& causes, const std::vector<HypothesisTest>& first_ranked,
                     Diagnosis& diagnosis) {
        diagnosis.cause = causes.front();
        diagnosis.further.assign(causes.begin() + 1, causes.end());
        diagnosis.runners_up.clear();
        for (std::size_t i = 1; i < first_ranked.size(); ++i)
            diagnosis.runners_up.push_back(first_ranked[i].outcome);
    }

    const DiagnosisInput& input_;
    DefectSet defect_set_;
    std::vector<Hypothesis> hypotheses_;
    Hypothesis declared_;
    Description description_;
    double open_bits_of_right_pixel_ = 0;
};

}  // namespace

double explained_share(const Explanation& e) {
    return e.asked == 0 ? 0 : double(e.explained) / double(e.asked);
}

std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict,
                                  std::span<const std::string> without) {
    if (defect_count(verdict) == verdict.counts[std::size_t(PixelClass::wrong_attribute)])
        return std::nullopt;
    if (scene.triangles.empty())  // there is nothing to draw wrongly
        return Diagnosis{.defects = defect_count(verdict), .cause = {}, .further = {}, .runners_up = {}};
    const DiagnosisInput input{scene, view, candidate, reference};
    return Diagnoser(input, verdict, without).run();
}

}  // namespace zproof
