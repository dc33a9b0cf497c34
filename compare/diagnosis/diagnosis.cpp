#include "compare/diagnosis/diagnosis.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/retrial.h"

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
        if (!passes(f.verdict)) holds_defect.at(column, row) = 1;
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
class Evidence {
  public:
    Evidence(const Frame& candidate, const Verdict& verdict) : candidate_(candidate), verdict_(verdict) {
        for (const Finding& f : verdict.findings)
            if (!passes(f.verdict)) defects_.push_back({f.x, f.y, f.candidate});
    }

    std::size_t defect_count() const { return defects_.size(); }
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
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> agreeing_;  ///< by width and height of the cell
};

struct Trial {
    const Hypothesis* hypothesis = nullptr;
    std::size_t place = 0;  ///< in the order of all hypotheses
    Explanation outcome;
    double gain = 0;  ///< share of the defects that would vanish, less those that would appear
    double leniency = 0;
};

bool explains_most(const Trial& trial) { return trial.gain > 0.5; }

/// The better first. Of equals, the narrowest, and then the more specific, which stood first.
void rank(std::vector<Trial>& trials) {
    std::ranges::sort(trials, {}, [](const Trial& t) { return std::tuple{-t.gain, t.leniency, t.place}; });
}

class Inquest {
  public:
    Inquest(const CaseFile& file, const Verdict& verdict)
        : file_(file), evidence_(file.candidate.frame, verdict), hypotheses_(all_hypotheses(file)) {}

    Diagnosis hold() {
        std::vector<Trial> held;
        for (const Kind kind : {Kind::firm, Kind::lenient, Kind::fitted}) {
            std::vector<Trial> trials = trials_of(kind);
            kind == Kind::lenient ? hold_lenient(trials) : hold(trials);
            held.insert(held.end(), trials.begin(), trials.end());
            rank(held);
            if (!held.empty() && explains_most(held.front())) break;
        }
        return diagnosis_from(held);
    }

  private:
    /// One wrong pixel proves no rule that would show all over the frame.
    bool may_apply(const Hypothesis& h) const {
        return evidence_.defect_count() > 1 ||
               (h.kind == Kind::firm && h.cell != file_.candidate.frame.size());
    }

    std::vector<Trial> trials_of(Kind kind) const {
        std::vector<Trial> trials;
        for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
            const Hypothesis& h = hypotheses_[i];
            if (h.kind == kind && may_apply(h))
                trials.push_back({&h, i, {.name = h.name, .description = h.description}});
        }
        return trials;
    }

    /// A second, larger round for those that explain most; for the first alone where it leaves nothing to
    /// explain.
    void hold(std::vector<Trial>& trials) {
        ask(trials, first_round);
        rank(trials);
        const auto rest = std::ranges::partition_point(trials, explains_most);
        const std::span hopeful(trials.begin(), rest);
        if (hopeful.empty()) return;
        ask(hopeful.first(1), second_round);
        if (hopeful.front().gain < 1) ask(hopeful.subspan(1), second_round);
    }

    /// One at a time, the narrowest first: behind one that leaves nothing to explain, wider ones have no say.
    void hold_lenient(std::vector<Trial>& trials) {
        const std::vector<Claim> defects = evidence_.defects(first_round);
        for (Trial& t : trials) t.leniency = leniency_of(file_, {t.hypothesis, defects});
        std::ranges::stable_sort(trials, {}, &Trial::leniency);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const std::span one = std::span(trials).subspan(i, 1);
            ask(one, first_round);
            if (trials[i].gain == 1) ask(one, second_round);
            if (trials[i].gain == 1) trials.resize(i + 1);
        }
        rank(trials);
        if (!trials.empty() && explains_most(trials.front())) ask(std::span(trials).first(1), second_round);
    }

    /// Puts up to `most` defects, and as many agreeing pixels, to every trial's hypothesis.
    void ask(std::span<Trial> trials, std::size_t most) {
        const std::vector<Claim> defects = evidence_.defects(most);
        std::vector<std::vector<Claim>> agreeing;
        for (const Trial& t : trials) agreeing.push_back(evidence_.agreeing(t.hypothesis->cell, most));
        std::vector<Question> questions;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            questions.push_back({trials[i].hypothesis, defects});
            questions.push_back({trials[i].hypothesis, agreeing[i]});
        }
        const std::vector<std::uint64_t> lawful = count_lawful(file_, questions);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            Explanation& e = trials[i].outcome;
            e.explained = lawful[2 * i];
            e.asked = defects.size();
            e.contradicted = agreeing[i].size() - lawful[2 * i + 1];
            e.checked = agreeing[i].size();
            trials[i].gain = gain_of(trials[i]);
        }
    }

    double gain_of(const Trial& trial) {
        const Explanation& e = trial.outcome;
        if (e.contradicted == 0) return explained_share(e);
        const double agreeing = double(evidence_.agreeing_count(trial.hypothesis->cell));
        const double appearing = double(e.contradicted) / double(e.checked) * agreeing;
        return explained_share(e) - appearing / double(evidence_.defect_count());
    }

    Diagnosis diagnosis_from(std::span<const Trial> ranked) const {
        Diagnosis diagnosis{.defects = evidence_.defect_count(), .cause = std::nullopt, .runners_up = {}};
        for (const Trial& trial : ranked) {
            if (&trial == &ranked.front() && explains_most(trial))
                diagnosis.cause = trial.outcome;
            else if (trial.gain > 0 && diagnosis.runners_up.size() < most_runners_up)
                diagnosis.runners_up.push_back(trial.outcome);
        }
        return diagnosis;
    }

    const CaseFile& file_;
    Evidence evidence_;
    std::vector<Hypothesis> hypotheses_;
};

}  // namespace

double explained_share(const Explanation& e) {
    return e.asked == 0 ? 0 : double(e.explained) / double(e.asked);
}

std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                  const RenderedFrame& reference, const Verdict& verdict) {
    if (defect_count(verdict) == 0) return std::nullopt;
    const CaseFile file{scene, view, candidate, reference};
    return Inquest(file, verdict).hold();
}

}  // namespace zproof
