/// What double precision, with its error bounded, says for certain of an answer (docs/truth-proofs.md,
/// "In double"). Where it says nothing, ask AdmissibleSet.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compare/admissible/neighbourhood.h"

namespace zproof {

/// Displacements are told in so many steps of eps.
inline constexpr int displacement_steps = 1024;

/// Half the side of the least square that is asked about: what is seen there needs no displacement.
constexpr double least_px(double eps_px) { return eps_px / displacement_steps; }

class ConservativeTest {
  public:
    /// The answer is a triangle or none. The neighbourhood must outlive the test.
    ConservativeTest(const Neighbourhood& around, PrimitiveId answer);

    enum class Finding { visible, tied, undecided };
    /// Visible, and no plane cuts anything in the square; or tied (admissibility.h).
    Finding finding() const;

    enum class Visibility { yes, no, undecided };
    /// Is it seen in the square of that half-side, at most eps: what AdmissibleSet::is_seen() and, for
    /// background, holds_background() say?
    Visibility seen_within(double half_side_px) const;

  private:
    /// What a triangle has of a square: a convex polygon.
    struct Part {
        std::array<PixelOffset, 8> corner;
        std::size_t count = 0;

        PixelOffset middle() const;
    };

    /// What values in the square may be off by: Neighbour has it for places within a pixel of the centre,
    /// twice pays for the evaluation.
    double edge_error(const Neighbour& n) const { return error_scale_ * n.edge_error; }
    double inverse_depth_error(const Neighbour& n) const { return error_scale_ * n.plane_error; }
    bool misses(const Neighbour& n, double half_side_px) const;
    bool is_inside_all_over(const Neighbour& n, std::size_t edge, double half_side_px) const;
    bool is_inside(const Neighbour& n, const PixelOffset& at) const;
    bool is_outside(const Neighbour& n, const PixelOffset& at) const;
    bool is_behind_answer(const Neighbour& n, const PixelOffset& at) const;
    bool is_clear_of_planes(const Neighbour& n) const;
    bool keeps_between_planes(const Neighbour& n, double half_side_px) const;
    bool is_seen_at(const PixelOffset& at) const;
    bool is_held_at(const PixelOffset& at) const;
    template <class IsThere>
    bool is_anywhere(double half_side_px, const IsThere& is_there) const;
    bool is_seen_around(double half_side_px) const;
    bool is_hidden_in(double half_side_px) const;
    bool covers_answer_in(const Neighbour& n, double half_side_px) const;
    bool shares_edge(const Neighbour& n, std::size_t edge) const;
    bool hides_in(const Neighbour& n, double half_side_px) const;
    Part part_in(double half_side_px) const;

    const Neighbourhood& around_;
    double error_scale_;
    const Neighbour* answer_ = nullptr;     ///< none for background
    std::vector<const Neighbour*> others_;  ///< that do not miss the square for certain, without the answer's
    bool is_asked_ = false;  ///< is there such an answer, its image certain, and cuts no plane anything?
};

}  // namespace zproof
