#include "compare/diagnosis/diagnosis.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <span>
#include <tuple>

#include "compare/diagnosis/attribute_causes.h"
#include "compare/diagnosis/defect_set.h"
#include "compare/diagnosis/description.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypothesis_check.h"

namespace zproof {

namespace {

constexpr std::size_t sifting = 32;  ///< defects of which a hypothesis must explain one to be asked more
constexpr std::size_t first_round = 128, second_round = 1000;  ///< claims of either kind per hypothesis
/// A hypothesis that spares less than the best, by this share, in the first round is not asked in the second.
constexpr double clearly_less = 0.2;
constexpr std::size_t at_a_time = 4;
constexpr std::size_t most_causes = 3;
constexpr std::size_t most_weighed = 32;    ///< hypotheses whose open answers are counted, for each cause
constexpr double least_saved_share = 0.75;  ///< of causes that are named (docs/diagnosis.md, "Calibration")
constexpr double least_part = 0.05;         ///< of what the defects take: what a further cause must spare
constexpr std::size_t most_runners_up = 3;

struct HypothesisTest {
    const Hypothesis* hypothesis = nullptr;
    std::size_t place = 0;  ///< in the order of all hypotheses
    Explanation outcome;
    std::uint64_t defects = 0;   ///< all that there are to explain
    bool speaks_of_all = false;  ///< Does it suppose the same of every pixel, and not of some parts?

    /// Does it say what must be wrong? What merely permits a defect leaves open why it is there.
    bool makes_what_it_explains() const {
        return hypothesis->only_permits || 2 * outcome.permitted < outcome.explained;
    }
    /// Pixels at which it may be mistaken, of so many.
    double slips(std::uint64_t pixels) const {
        return hypothesis->reads_surroundings ? alike_shares * double(pixels) : 0;
    }
    /// Does no pixel that was asked speak against it, the defects that it leaves apart?
    bool is_not_refuted() const {
        return double(outcome.contradicted) <= slips(outcome.checked) && makes_what_it_explains();
    }
    std::uint64_t left() const { return outcome.asked - outcome.explained; }
    /// One wrong pixel proves nothing, neither for a rule nor against it.
    bool leaves_nothing() const {
        return double(left()) <= slips(outcome.asked) || (left() == 1 && outcome.asked == defects);
    }
    /// Where a rule holds for the whole frame, other things may be wrong with it as well: here so few that no
    /// further cause is asked of them.
    bool leaves_little() const {
        return speaks_of_all && !hypothesis->only_permits && !hypothesis->tells_numbers &&
               double(left()) <= least_part * double(outcome.asked);
    }
    bool explains_all() const {
        return is_not_refuted() && leaves_nothing() && outcome.saved_share >= least_saved_share;
    }
    /// Is it the whole cause, as far as was asked, and not only the least of several that would permit it?
    bool suffices() const { return explains_all() && !hypothesis->only_permits; }
};

/// Is all that the other one admits admissible under it as well, since it supposes fewer sub-pixel bits?
bool permits_more(const Hypothesis& a, const Hypothesis& b) {
    const auto is_of_bits = [](const Hypothesis& h) {
        return h.only_permits && !h.restate && !h.amend && !h.report;
    };
    const auto *coarse = std::get_if<RasterPrecision>(&a.precision),
               *fine = std::get_if<RasterPrecision>(&b.precision);
    if (!coarse || !fine || !is_of_bits(a) || !is_of_bits(b)) return false;
    RasterPrecision with_bits = *coarse;
    with_bits.subpixel_bits = fine->subpixel_bits;
    return coarse->subpixel_bits < fine->subpixel_bits && with_bits == *fine;
}

/// The better first: what suffices, then what saves more. Of equals, the more specific, which stood first.
void rank(std::span<HypothesisTest> tests) {
    std::ranges::sort(tests, {}, [](const HypothesisTest& t) {
        return std::tuple{!t.suffices(), -t.outcome.saved_bits, t.place};
    });
}

bool is_better(const HypothesisTest& a, const HypothesisTest& b) {
    return std::pair{a.suffices(), a.outcome.saved_bits} > std::pair{b.suffices(), b.outcome.saved_bits};
}

/// "Depth is told times 1.1." as a clause.
std::string clause_of(std::string sentence) {
    sentence.front() = char(std::tolower(std::uint8_t(sentence.front())));
    sentence.pop_back();
    return sentence;
}

class Diagnoser {
  public:
    Diagnoser(const DiagnosisInput& input, const Verdict& verdict, std::vector<Hypothesis> hypotheses,
              std::span<const std::string> without)
        : input_(input),
          defect_set_(input, verdict),
          hypotheses_(std::move(hypotheses)),
          declared_(as_declared(input, {})),
          description_(input, hypotheses_.size()) {
        std::erase_if(hypotheses_,
                      [&](const Hypothesis& h) { return std::ranges::count(without, h.cause.name) > 0; });
        open_bits_of_right_pixel_ = open_bits_of_right_pixel();
    }

    bool knows(const EarlierCause& earlier) const {
        const auto has_name = [&](const Hypothesis& h) { return h.cause.name == earlier.name; };
        return std::ranges::any_of(hypotheses_, has_name);
    }

    Diagnosis run() {
        std::vector<HypothesisTest> first = best_tests();
        Diagnosis diagnosis = without_cause(first);
        if (const std::vector<Explanation> causes = all_causes(first); !causes.empty()) {
            name(causes, first, diagnosis);
            return diagnosis;
        }
        const auto whole = std::ranges::find_if(first, &HypothesisTest::leaves_nothing);
        const bool is_least = whole != first.end() && whole->hypothesis->only_permits;
        if (!is_least || !whole->explains_all()) return diagnosis;
        std::rotate(first.begin(), whole, whole + 1);
        name({first.front().outcome}, first, diagnosis);
        return diagnosis;
    }

    /// Nothing where none of them explains this view.
    std::optional<Diagnosis> by_earlier(std::span<const EarlierCause> earlier) {
        const auto known = [&](const HypothesisTest& t) {
            return std::ranges::find(earlier, t.outcome.name, &EarlierCause::name);
        };
        std::vector<HypothesisTest> tests = all_tests(earlier);
        std::erase_if(tests, [&](const auto& t) { return known(t) == earlier.end(); });
        const auto fails = [](const HypothesisTest& t) {
            return !t.is_not_refuted() || !(t.leaves_nothing() || t.leaves_little());
        };
        for (const std::size_t round : {first_round, second_round}) {
            if (tests.empty()) return std::nullopt;
            ask(tests, round, CheckDetail::admissibility);
            std::erase_if(tests, fails);
        }
        count_open_bits(tests);
        // a renderer's rule holds in every view, also where it permits much and is seen little
        std::erase_if(tests,
                      [](const HypothesisTest& t) { return !t.speaks_of_all && t.outcome.saved_bits <= 0; });
        std::erase_if(tests, [&](const HypothesisTest& t) {
            const EarlierCause& before = *known(t);
            return before.saved_bits + t.outcome.saved_bits <
                   least_saved_share * (before.all_bits + bits_of_defects());
        });
        if (tests.empty()) return std::nullopt;
        rank(tests);
        Diagnosis diagnosis = without_cause(tests);
        name({tests.front().outcome}, tests, diagnosis);
        return diagnosis;
    }

  private:
    /// One wrong pixel proves no rule that would show all over the frame. What moves triangles shows at
    /// edges, of this view or of one that it explained.
    bool may_apply(const Hypothesis& h, std::span<const EarlierCause> earlier) const {
        const bool is_known = std::ranges::count(earlier, h.cause.name, &EarlierCause::name) > 0;
        if (h.moves_triangles && !is_known && !input_.said && defect_set_.are_all_depths()) return false;
        return defect_set_.defect_count() > 1 || h.cell != input_.candidate.frame.size();
    }

    /// From the first round's claims, while the tests keep what they explain of the second's.
    void count_open_bits(std::vector<HypothesisTest>& tests) {
        std::vector<HypothesisTest> weighed = tests;
        ask(weighed, first_round, CheckDetail::open_bits);
        for (std::size_t i = 0; i < tests.size(); ++i) {
            tests[i].outcome.saved_bits = weighed[i].outcome.saved_bits;
            tests[i].outcome.saved_share = weighed[i].outcome.saved_share;
        }
    }

    /// One cause after the other, each of what those before it left. None where they do not explain the view.
    std::vector<Explanation> all_causes(const std::vector<HypothesisTest>& first) {
        const double all_bits = bits_of_defects();
        double saved_bits = 0;
        std::vector<Explanation> causes;
        for (std::vector<HypothesisTest> best = first; !best.empty();
             best = best_tests(least_part * all_bits)) {
            if (is_one_of_several(best)) put_what_supposes_no_rule_first(best);
            const HypothesisTest& cause = best.front();
            if (!cause.is_not_refuted() || is_one_of_several(best)) return {};
            if (!cause.suffices() && cause.outcome.saved_bits < least_part * all_bits) return {};
            saved_bits += cause.outcome.saved_bits;
            causes.push_back(cause.outcome);
            const bool is_the_last = cause.leaves_nothing() || cause.leaves_little();
            defect_set_.keep(is_the_last ? std::vector<Claim>() : left_by(*cause.hypothesis));
            if (causes.size() == most_causes) break;
        }
        if (defect_set_.defect_count() > 0 || saved_bits < least_saved_share * all_bits) return {};
        return causes;
    }

    std::vector<HypothesisTest> all_tests(std::span<const EarlierCause> earlier = {}) const {
        std::vector<HypothesisTest> tests;
        for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
            const Hypothesis& h = hypotheses_[i];
            const auto& [name, description, look_at] = h.cause;
            if (may_apply(h, earlier))
                tests.push_back(
                    {&h,
                     i,
                     {.name = name,
                      .description = description,
                      .look_at = look_at,
                      .fitted = h.fits_a_limit || h.tells_numbers ? clause_of(description) : ""}});
        }
        return tests;
    }

    /// The best, ranked; those alone that save anything. Where less than `least_bits` can be saved, those
    /// alone that suffice.
    std::vector<HypothesisTest> best_tests(double least_bits = 0) {
        if (defect_set_.defect_count() == 0) return {};
        std::vector<HypothesisTest> tests = all_tests();
        const bool must_suffice = bits_of_defects() < least_bits;
        if (must_suffice) std::erase_if(tests, [](const auto& t) { return t.hypothesis->only_permits; });
        drop_what_explains_nothing(tests);
        ask(tests, first_round, CheckDetail::admissibility);
        if (must_suffice) std::erase_if(tests, [](const auto& t) { return !t.suffices(); });
        rank(tests);
        drop_what_permits_more(tests);
        tests.resize(with_open_bits(tests));
        ask_those_that_may_be_best(tests);
        rank(tests);
        std::erase_if(tests, [](const HypothesisTest& t) { return t.outcome.saved_bits <= 0; });
        put_unlearned_first(tests);
        return tests;
    }

    std::size_t explained_of(std::span<const ClaimCheck> checks) const {
        return std::size_t(std::ranges::count_if(checks, &ClaimCheck::is_admissible));
    }

    /// And what a quarter of the agreeing pixels contradict, so that it saves nothing.
    void drop_what_explains_nothing(std::vector<HypothesisTest>& tests) {
        const ClaimSample few = defect_set_.defects(sifting);
        std::vector<HypothesisQuery> queries;
        for (const HypothesisTest& t : tests) queries.push_back({t.hypothesis, few.claims});
        const auto checks = check_claims(input_, queries, CheckDetail::admissibility);
        std::vector<HypothesisTest> kept;
        for (std::size_t i = 0; i < tests.size(); ++i)
            if (explained_of(checks[i]) > 0) kept.push_back(std::move(tests[i]));
        ask(kept, sifting, CheckDetail::admissibility);
        std::erase_if(kept, [](const HypothesisTest& t) {
            return t.outcome.saved_bits <= 0 && 4 * t.outcome.contradicted >= t.outcome.checked &&
                   t.outcome.contradicted > 0;
        });
        tests = std::move(kept);
    }

    /// What permits more than one that leaves nothing makes the description no shorter.
    void drop_what_permits_more(std::vector<HypothesisTest>& tests) const {
        for (std::size_t i = 0; i < tests.size(); ++i) {
            const Hypothesis& enough = *tests[i].hypothesis;
            const auto is_more = [&](const HypothesisTest& t) { return permits_more(*t.hypothesis, enough); };
            if (!tests[i].leaves_nothing() || std::ranges::none_of(tests, is_more)) continue;
            const ClaimSample defects = defect_set_.defects(second_round);
            const HypothesisQuery query{&enough, defects.claims};
            const auto checks = check_claims(input_, {&query, 1}, CheckDetail::admissibility);
            if (explained_of(checks.front()) == defects.claims.size()) std::erase_if(tests, is_more);
        }
    }

    /// The second round.
    void ask_those_that_may_be_best(std::vector<HypothesisTest>& ranked) {
        if (ranked.empty()) return;
        double together = 0;  // of as many as can be named together
        for (const HypothesisTest& t : std::span(ranked).first(std::min(ranked.size(), most_causes)))
            together += std::max(0.0, t.outcome.saved_share);
        if (together < least_saved_share - clearly_less) return;
        const double least_share = ranked.front().outcome.saved_share - clearly_less;
        const auto rest = std::ranges::stable_partition(ranked, [&](const HypothesisTest& t) {
            return t.outcome.saved_bits > 0 && t.outcome.saved_share > least_share;
        });
        ask(std::span(ranked.begin(), rest.begin()), second_round, CheckDetail::open_bits);
    }

    /// How many of them do as well as the first.
    static std::size_t alike(std::span<const HypothesisTest> ranked) {
        const HypothesisTest& best = ranked.front();
        const auto is_alike = [&](const HypothesisTest& t) {
            return t.suffices() == best.suffices() &&
                   t.outcome.saved_share > best.outcome.saved_share - alike_shares;
        };
        return std::size_t(std::ranges::find_if_not(ranked, is_alike) - ranked.begin());
    }

    /// Where several do as well as the best, what speaks of the whole frame stands before what speaks of
    /// parts, what learned less from the frames before what learned more, and what the catalogue has first.
    void put_unlearned_first(std::vector<HypothesisTest>& ranked) const {
        if (ranked.empty()) return;
        const Resolution whole = input_.candidate.frame.size();
        std::ranges::stable_sort(std::span(ranked).first(alike(ranked)), {}, [&](const HypothesisTest& t) {
            return std::tuple{t.hypothesis->cell != whole, t.hypothesis->learned_bits, t.place};
        });
    }

    /// Does another one, which rests on no more, do as well: a rule of another kind, or another fitted limit?
    /// Then the frame does not tell which it is.
    static bool is_one_of_several(std::span<const HypothesisTest> ranked) {
        const Hypothesis& best = *ranked.front().hypothesis;
        if (best.supposes_no_rule) return false;
        return std::ranges::any_of(ranked.subspan(1, alike(ranked) - 1), [&](const HypothesisTest& t) {
            const Hypothesis& other = *t.hypothesis;
            if (other.only_permits || other.supposes_no_rule || other.cell != best.cell) return false;
            if (best.fits_a_limit) return other.fits_a_limit && other.learned_bits <= best.learned_bits;
            return best.learned_bits == 0 && other.learned_bits == 0 && other.kind != best.kind;
        });
    }

    /// Sorts those that do as well as the best.
    static void put_what_supposes_no_rule_first(std::vector<HypothesisTest>& ranked) {
        std::stable_partition(ranked.begin(), ranked.begin() + std::ptrdiff_t(alike(ranked)),
                              [](const HypothesisTest& t) { return t.hypothesis->supposes_no_rule; });
    }

    /// Counts what those that seem best leave open, a few at a time, and ranks them anew; how many of them
    /// are worth a larger sample. What is left open makes a description longer: the rest cannot save more
    /// than they seemed to.
    std::size_t with_open_bits(std::span<HypothesisTest> ranked) {
        std::size_t asked = 0;
        const auto may_be_best = [&](const HypothesisTest& t) {
            return t.outcome.saved_bits > 0 &&
                   std::ranges::all_of(ranked.first(asked),
                                       [&](const auto& weighed) { return is_better(t, weighed); });
        };
        while (asked < std::min(ranked.size(), most_weighed) && may_be_best(ranked[asked])) {
            const std::span next = ranked.subspan(asked, std::min(at_a_time, ranked.size() - asked));
            ask(next, first_round, CheckDetail::open_bits);
            asked += next.size();
        }
        rank(ranked.first(asked));
        return std::min(asked, most_runners_up + 1);
    }

    /// Puts up to `most` defects, and as many agreeing pixels, to every test's hypothesis; and what is right
    /// at the defects, where open answers are counted.
    void ask(std::span<HypothesisTest> tests, std::size_t most, CheckDetail detail) {
        const ClaimSample defects = defect_set_.defects(most);
        const std::vector<Claim> right =
            detail == CheckDetail::open_bits ? right_answers(defects.claims) : std::vector<Claim>();
        std::vector<ClaimSample> agreeing;
        std::vector<std::vector<Claim>> of_both;  // defects, then agreeing pixels: asked together, for speed
        for (const HypothesisTest& t : tests) {
            agreeing.push_back(defect_set_.agreeing(t.hypothesis->cell, most));
            of_both.push_back(defects.claims);
            of_both.back().insert(of_both.back().end(), agreeing.back().claims.begin(),
                                  agreeing.back().claims.end());
        }
        std::vector<HypothesisQuery> queries;
        for (std::size_t i = 0; i < tests.size(); ++i) {
            queries.push_back({tests[i].hypothesis, of_both[i]});
            const bool needs_right = !tests[i].hypothesis->only_permits;
            queries.push_back({tests[i].hypothesis, needs_right ? std::span(right) : std::span<const Claim>(),
                               CheckDetail::admissibility});
        }
        const std::vector<std::vector<ClaimCheck>> checks = check_claims(input_, queries, detail);
        for (std::size_t i = 0; i < tests.size(); ++i) {
            const double declared_bits = detail == CheckDetail::open_bits
                                             ? open_bits_as_declared(tests[i].hypothesis->cell, agreeing[i])
                                             : 0;
            const std::span of_defects = std::span(checks[2 * i]).first(defects.claims.size()),
                            of_agreeing = std::span(checks[2 * i]).subspan(defects.claims.size());
            tell(tests[i], {defects, of_defects}, {agreeing[i], of_agreeing}, declared_bits);
            tests[i].outcome.permitted = both_admissible(of_defects, checks[2 * i + 1]);
        }
    }

    /// What the reference says at these places.
    std::vector<Claim> right_answers(std::vector<Claim> claims) const {
        const Frame& reference = input_.reference.frame;
        for (Claim& claim : claims) {
            claim.answer = {reference.primitive.at(claim.x, claim.y),
                            reference.camera_depth.at(claim.x, claim.y)};
            if (input_.said) claim.label = label_of(input_.said->labels, claim.answer.primitive);
        }
        return claims;
    }

    /// 0 where one of them was not asked.
    static std::uint64_t both_admissible(std::span<const ClaimCheck> some,
                                         std::span<const ClaimCheck> other) {
        std::uint64_t both = 0;
        for (std::size_t i = 0; i < std::min(some.size(), other.size()); ++i)
            both += some[i].is_admissible && other[i].is_admissible;
        return both;
    }

    struct Checked {
        const ClaimSample& sample;
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
    void tell(HypothesisTest& test, const Checked& defects, const Checked& agreeing, double declared_bits) {
        const Hypothesis& h = *test.hypothesis;
        Explanation& e = test.outcome;
        test.defects = defect_set_.defect_count();
        test.speaks_of_all = h.cell == input_.candidate.frame.size();
        e.explained = defects.admissible();
        e.asked = defects.checks.size();
        e.contradicted = agreeing.checks.size() - agreeing.admissible();
        e.checked = agreeing.checks.size();
        const auto [with_defects, all_cells] = defect_set_.cells(h.cell);
        const double told_with = description_.of_name() + h.learned_bits +
                                 bits_of_choice(with_defects, all_cells) +
                                 description_.of_exceptions(defects.exceptions() + agreeing.exceptions()) +
                                 defects.open_bits() + agreeing.open_bits() - declared_bits;
        e.saved_bits = description_.of_exceptions(defect_set_.pixel_count()) - told_with;
        e.saved_share = std::min(1.0, e.saved_bits / bits_of_defects());
    }

    /// What a description can spare at most: all that the defects take but what a right pixel leaves open.
    double bits_of_defects() const {
        return description_.of_exceptions(defect_set_.pixel_count()) -
               defect_set_.pixel_count() * open_bits_of_right_pixel_;
    }

    /// The mean over the defects, by the reference's answers there.
    double open_bits_of_right_pixel() {
        const std::vector<Claim> claims = right_answers(defect_set_.defects(first_round).claims);
        const HypothesisQuery query{&declared_, claims};
        const auto checks = check_claims(input_, {&query, 1}, CheckDetail::open_bits);
        double sum = 0;
        for (const ClaimCheck& check : checks.front()) sum += check.open_bits;
        return sum / double(claims.size());
    }

    /// What the declared rule leaves open at the agreeing pixels beside defects in such cells; asked once.
    double open_bits_as_declared(Resolution cell, const ClaimSample& agreeing) {
        const auto [entry, is_new] =
            declared_bits_.try_emplace({cell.width, cell.height, agreeing.claims.size()});
        if (!is_new) return entry->second;
        const HypothesisQuery query{&declared_, agreeing.claims};
        const auto checks = check_claims(input_, {&query, 1}, CheckDetail::open_bits);
        return entry->second = Checked{agreeing, checks.front()}.open_bits();
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

    static bool have_equal_planes(const Hypothesis& one, const Hypothesis& other) {
        const Camera &a = one.view.camera, &b = other.view.camera;
        return a.near_depth == b.near_depth && a.far_depth == b.far_depth;
    }

    /// Names the best first, and its runners-up; not those that do as well because they fit more numbers.
    /// What fits another near or far plane is another story.
    static void name(const std::vector<Explanation>& causes, const std::vector<HypothesisTest>& first_ranked,
                     Diagnosis& diagnosis) {
        diagnosis.cause = causes.front();
        diagnosis.further.assign(causes.begin() + 1, causes.end());
        diagnosis.runners_up.clear();
        const HypothesisTest& cause = first_ranked.front();
        for (const HypothesisTest& t : std::span(first_ranked).subspan(1))
            if (!t.suffices() || t.hypothesis->learned_bits <= cause.hypothesis->learned_bits ||
                !have_equal_planes(*t.hypothesis, *cause.hypothesis))
                diagnosis.runners_up.push_back(t.outcome);
    }

    const DiagnosisInput& input_;
    DefectSet defect_set_;
    std::vector<Hypothesis> hypotheses_;
    Hypothesis declared_;
    Description description_;
    double open_bits_of_right_pixel_ = 0;
    /// By width and height of the cell, and the number of pixels.
    std::map<std::tuple<int, int, std::size_t>, double> declared_bits_;
};

/// By what explained earlier views, if that explains this one; else by all hypotheses.
Diagnosis diagnosed(const DiagnosisInput& input, const Verdict& verdict, std::span<const std::string> without,
                    std::span<const EarlierCause> earlier) {
    if (!earlier.empty()) {
        std::vector<std::string> names;
        for (const EarlierCause& e : earlier) names.push_back(e.name);
        Diagnoser quick(input, verdict, hypotheses_named(names, input), without);
        if (std::ranges::all_of(earlier, [&](const EarlierCause& e) { return quick.knows(e); })) {
            if (const std::optional<Diagnosis> known = quick.by_earlier(earlier)) return *known;
            earlier = {};
        }
    }
    Diagnoser diagnoser(input, verdict, all_hypotheses(input), without);
    if (const std::optional<Diagnosis> known = diagnoser.by_earlier(earlier)) return *known;
    return diagnoser.run();
}

}  // namespace

std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict,
                                  const FrameAsGiven& given, std::span<const std::string> without,
                                  std::span<const EarlierCause> earlier) {
    if (defect_count(verdict) == 0) return std::nullopt;
    if (scene.triangles.empty())  // there is nothing to draw wrongly
        return Diagnosis{.defects = defect_count(verdict), .cause = {}, .further = {}, .runners_up = {}};
    const DiagnosisInput input{
        scene, view, candidate, reference, given.said ? &*given.said : nullptr, given.convention};
    std::optional<Diagnosis> of_attributes = diagnose_attributes(input, verdict);
    if (defect_count(verdict) == verdict.counts[std::size_t(PixelClass::wrong_attribute)])
        return of_attributes;
    Diagnosis diagnosis = diagnosed(input, verdict, without, earlier);
    const bool has_room = diagnosis.cause && diagnosis.further.size() + 1 < most_causes;
    if (has_room && of_attributes && of_attributes->cause) diagnosis.further.push_back(*of_attributes->cause);
    return diagnosis;
}

}  // namespace zproof
