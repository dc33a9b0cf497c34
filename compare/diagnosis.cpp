#include "compare/diagnosis.h"

#include <algorithm>

#include "compare/hypotheses/catalogue.h"
#include "compare/retrial.h"

namespace zproof {

namespace {

constexpr std::size_t first_round = 128, second_round = 2000;  ///< claims of either kind per hypothesis
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

/// The defects and the pixels that agree, of one view.
class Record {
  public:
    Record(const Frame& candidate, const Verdict& verdict) : candidate_(candidate) {
        for (const Finding& f : verdict.findings)
            if (!passes(f.verdict)) defects_.push_back({f.x, f.y, f.candidate});
        const auto classes = verdict.classes.pixels();
        for (std::size_t i = 0; i < classes.size(); ++i)
            if (classes[i] == PixelClass::agree) agreeing_.push_back(std::uint32_t(i));
    }

    std::size_t defect_count() const { return defects_.size(); }
    std::size_t agreeing_count() const { return agreeing_.size(); }

    std::vector<Claim> defects(std::size_t most) const {
        std::vector<Claim> claims;
        for (const std::size_t i : spread(defects_.size(), most)) claims.push_back(defects_[i]);
        return claims;
    }
    std::vector<Claim> agreeing(std::size_t most) const {
        std::vector<Claim> claims;
        for (const std::size_t i : spread(agreeing_.size(), most)) claims.push_back(claim_at(agreeing_[i]));
        return claims;
    }

  private:
    Claim claim_at(std::size_t pixel) const {
        const auto width = std::size_t(candidate_.size().width);
        return {int(pixel % width),
                int(pixel / width),
                {candidate_.primitive.pixels()[pixel], candidate_.camera_depth.pixels()[pixel]}};
    }

    const Frame& candidate_;
    std::vector<Claim> defects_;
    std::vector<std::uint32_t> agreeing_;
};

struct Trial {
    const Hypothesis* hypothesis = nullptr;
    Explanation outcome;
    double gain = 0;  ///< share of the defects that would vanish, less those that would appear
};

class Inquest {
  public:
    Inquest(const CaseFile& file, const Record& record) : file_(file), record_(record) {}

    /// Puts up to `most` defects, and as many agreeing pixels, to every trial's hypothesis.
    void ask(std::vector<Trial>& trials, std::size_t most) const {
        const std::vector<Claim> defects = record_.defects(most), agreeing = record_.agreeing(most);
        std::vector<Question> questions;
        for (const Trial& trial : trials) {
            questions.push_back({trial.hypothesis, defects});
            const bool heard = trial.hypothesis->scope == Scope::frame;
            questions.push_back({trial.hypothesis, heard ? std::span(agreeing) : std::span<const Claim>()});
        }
        const std::vector<std::uint64_t> lawful = count_lawful(file_, questions);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            Explanation& o = trials[i].outcome;
            o.explained = lawful[2 * i];
            o.asked = defects.size();
            o.checked = questions[2 * i + 1].claims.size();
            o.contradicted = o.checked - lawful[2 * i + 1];
            trials[i].gain = gain_of(o);
        }
    }

  private:
    double gain_of(const Explanation& o) const {
        const double appearing =
            o.checked == 0 ? 0
                           : double(o.contradicted) / double(o.checked) * double(record_.agreeing_count());
        return explained_share(o) - appearing / double(record_.defect_count());
    }

    const CaseFile& file_;
    const Record& record_;
};

/// The better first; of equals the more specific, which stood first.
void rank(std::vector<Trial>& trials) { std::ranges::stable_sort(trials, std::greater<>{}, &Trial::gain); }

}  // namespace

double explained_share(const Explanation& e) {
    return e.asked == 0 ? 0 : double(e.explained) / double(e.asked);
}

std::optional<Diagnosis> diagnose(const Scene& scene, const View& view, const Testimony& candidate,
                                  const Testimony& reference, const Verdict& verdict) {
    const Record record(candidate.frame, verdict);
    if (record.defect_count() == 0) return std::nullopt;
    const CaseFile file{scene, view, candidate, reference};
    const std::vector<Hypothesis> hypotheses = all_hypotheses(file);
    const Inquest inquest(file, record);
    const auto explains_most = [](const Trial& t) { return t.gain > 0.5; };

    std::vector<Trial> trials;
    for (const Hypothesis& h : hypotheses) trials.push_back({&h, {h.name, h.description}});
    inquest.ask(trials, first_round);
    const auto rest = std::ranges::stable_partition(trials, explains_most);
    const std::vector<Trial> others(rest.begin(), rest.end());
    trials.erase(rest.begin(), rest.end());
    inquest.ask(trials, second_round);
    trials.insert(trials.end(), others.begin(), others.end());
    rank(trials);

    Diagnosis diagnosis{.defects = record.defect_count(), .cause = std::nullopt, .runners_up = {}};
    for (const Trial& trial : trials) {
        if (&trial == &trials.front() && explains_most(trial))
            diagnosis.cause = trial.outcome;
        else if (trial.gain > 0 && diagnosis.runners_up.size() < most_runners_up)
            diagnosis.runners_up.push_back(trial.outcome);
    }
    return diagnosis;
}

}  // namespace zproof
