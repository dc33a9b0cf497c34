#include "filters/conformance/joint_fit.h"

#include <cmath>
#include <numeric>

namespace zproof {

namespace {

/// Finds the offsets of one picture.
class Fitter {
  public:
    Fitter(const Picture& picture, const Samples& samples, const JointReferences& references)
        : samples_(samples),
          references_(references),
          size_(picture.size()),
          shown_(shown_by(picture, samples)),
          count_(references.offsets.size()) {}

    OffsetFit fit() const {
        const Step first = step_from(linear());
        OffsetFit found = result(first.step, first.errors,
                                 [&](const std::vector<double>& offsets) { return less_changes(offsets); });
        std::vector<double> offsets = first.step;
        for (int round = 0; round < most_rounds; ++round) {
            const Step step = step_from(at(offsets));
            if (is_small(step, 0.1) || !descend(offsets, step.step)) {
                if (!is_small(step, 1)) return found;
                found = result(offsets, step.errors,
                               [&](const std::vector<double>& o) { return residual_at(o); });
                found.has_converged = true;
                return found;
            }
        }
        return found;
    }

  private:
    static constexpr int most_rounds = 20, most_halvings = 4;

    /// The picture's difference from the definition, and how that answers to each offset; 0 where undecided.
    struct Linearised {
        Values residual;
        std::vector<Values> changes;
    };
    struct Step {
        std::vector<double> step, errors;
    };

    Linearised linear() const {
        Linearised all{less_changes(std::vector<double>(count_, 0)), {}};
        for (const Response& response : samples_.responses) all.changes.push_back(response.change);
        return all;
    }

    Linearised at(const std::vector<double>& offsets) const {
        Linearised all{residual_at(offsets), {}};
        for (std::size_t k = 0; k < count_; ++k) {
            all.changes.emplace_back(shown_.size(), 0);
            if (!samples_.responses[k].is_told()) continue;
            std::vector<double> less = offsets, more = offsets;
            less[k] -= joint_step, more[k] += joint_step;
            const Values below = residual_at(less), above = residual_at(more);
            for (std::size_t i = 0; i < shown_.size(); ++i)
                all.changes[k][i] = (below[i] - above[i]) / (2 * joint_step);
        }
        return all;
    }

    Values residual_at(const std::vector<double>& offsets) const {
        const auto values = values_of(references_.shifted(offsets), samples_.pixels);
        Values residual(shown_.size(), 0);
        for (std::size_t i = 0; i < shown_.size(); ++i)
            if (values[i / 3]) residual[i] = shown_[i] - (*values[i / 3])[int(i % 3)];
        return residual;
    }

    Values less_changes(const std::vector<double>& offsets) const {
        Values residual = shown_;
        for (std::size_t i = 0; i < residual.size(); ++i) {
            residual[i] -= samples_.exact[i];
            for (std::size_t k = 0; k < count_; ++k)
                residual[i] -= offsets[k] * samples_.responses[k].change[i];
        }
        return residual;
    }

    /// Least squares; what is left tells the standard errors.
    Step step_from(const Linearised& from) const {
        Step found{std::vector<double>(count_, 0), std::vector<double>(count_, 0)};
        std::vector<Values> unique(count_);
        Values rest = from.residual;
        for (std::size_t k = 0; k < count_; ++k) {
            if (!samples_.responses[k].is_told()) continue;
            std::vector<const Values*> others;
            for (std::size_t j = 0; j < count_; ++j)
                if (j != k) others.push_back(&from.changes[j]);
            unique[k] = without(samples_.weight, from.changes[k], others);
            const double length2 = weighted_dot(samples_.weight, unique[k], unique[k]);
            if (length2 > 0)
                found.step[k] = weighted_dot(samples_.weight, unique[k], from.residual) / length2;
        }
        for (std::size_t k = 0; k < count_; ++k)
            for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= found.step[k] * from.changes[k][i];
        for (std::size_t k = 0; k < count_; ++k)
            if (!unique[k].empty()) found.errors[k] = error_of(unique[k], rest);
        return found;
    }

    double error_of(const Values& unique, const Values& rest) const {
        const double length2 = weighted_dot(samples_.weight, unique, unique);
        if (!(length2 > 0)) return 0;
        Blocks errors{size_};
        for (std::size_t i = 0; i < rest.size(); ++i)
            errors.add(samples_.pixels[i / 3], samples_.weight[i] * unique[i] * rest[i] / length2);
        return standard_error(errors);
    }

    bool is_small(const Step& step, double share) const {
        for (std::size_t k = 0; k < count_; ++k)
            if (!(std::abs(step.step[k]) <= share * step.errors[k])) return false;
        return true;
    }

    /// Goes as much of the step as makes the squares less; does any?
    bool descend(std::vector<double>& offsets, const std::vector<double>& step) const {
        const auto squares = [&](const std::vector<double>& at_offsets) {
            const Values residual = residual_at(at_offsets);
            return weighted_dot(samples_.weight, residual, residual);
        };
        const double now = squares(offsets);
        double share = 1;
        for (int halvings = 0; halvings <= most_halvings; ++halvings, share /= 2) {
            std::vector<double> next = offsets;
            for (std::size_t k = 0; k < count_; ++k) next[k] += share * step[k];
            if (!(squares(next) < now)) continue;
            offsets = next;
            return true;
        }
        return false;
    }

    template <class Residual>
    OffsetFit result(const std::vector<double>& offsets, const std::vector<double>& errors,
                     const Residual& residual) const {
        OffsetFit found{offsets, errors, false, residual(offsets), {}};
        for (std::size_t k = 0; k < count_; ++k) {
            std::vector<double> others = offsets;
            others[k] = 0;
            found.residual_without.push_back(residual(others));
        }
        return found;
    }

    const Samples& samples_;
    const JointReferences& references_;
    Resolution size_;
    Values shown_;
    std::size_t count_;
};

}  // namespace

double standard_error(const Blocks& errors) {
    const auto root = [](const std::vector<double>& sums) {
        return std::sqrt(std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0));
    };
    return std::max(root(errors.rows), root(errors.columns));
}

OffsetFit fit_offsets(const Picture& picture, const Samples& samples, const JointReferences& references) {
    return Fitter{picture, samples, references}.fit();
}

}  // namespace zproof
