#include "compare/judge.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "compare/first_pass/agreement.h"
#include "compare/hearing/adjudication.h"
#include "compare/judge_in_full.h"
#include "compare/layers/layered_tiles.h"

namespace zproof {

namespace {

/// What is wanted of errors of depth.
enum class Depths { largest, histograms };

/// What comes of judging; all of it only where somebody wants that.
struct Kept {
    Verdict& verdict;
    Depths depths;
    JudgedInFull* full;
};

/// The pixels that stay open; depths are counted into the verdict.
OpenTiles first_pass(const Comparands& of, const Kept& kept) {
    OpenTiles open(of.view);
    const Wanted wanted{kept.depths == Depths::histograms, kept.full ? &kept.full->errors : nullptr};
    const Tally tally = compare_frames(of.scene, of.candidate, of.reference, wanted, open);
    kept.verdict.candidate_depth = tally.candidate;
    kept.verdict.reference_depth = tally.reference;
    return open;
}

/// All agree, and other classes may be written where pixels are open.
ClassMap room_for(const OpenTiles& open, Resolution size) {
    ClassMap classes(size);
    tbb::parallel_for(0, open.tiles().rows, [&](int row) {
        classes.reserve(row, open.of_row(row).size());
        for (const OpenTiles::Tile& tile : open.of_row(row)) classes.open(tile.column, row);
    });
    return classes;
}

bool reference_is_wrong(const OpenPixel& open, const Ruling& ruling) {
    return open.reference_invalid || !open.reference_depth_lawful ||
           !is_lawful(ruling.reference.decision.standing);
}

/// Does a stand before b in raster order?
bool in_raster(const PixelPlace& a, const PixelPlace& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }

/// What some of the findings add up to: integers and maxima, so the order of adding does not matter.
struct Count {
    ClassCounts classes{};
    Tally edges;
    std::uint64_t reference_defects = 0, adjudicated = 0, exact = 0;

    void add(const OpenPixel& open, bool ids_differ, const Ruling& ruling) {
        ++classes[std::size_t(open.finding.verdict)];
        reference_defects += reference_is_wrong(open, ruling);
        adjudicated += ids_differ;
        exact += ruling.candidate.decision.exact || ruling.reference.decision.exact;
        if (const auto& d = ruling.candidate.displacement_over_eps) count(edges.candidate, *d);
        if (const auto& d = ruling.reference.displacement_over_eps) count(edges.reference, *d);
    }
    /// Lawful answers that differ.
    void add(const ClassCounts& layered) {
        for (std::size_t c = 0; c < classes.size(); ++c) {
            classes[c] += layered[c];
            adjudicated += layered[c];
        }
    }
};

Count operator+(Count a, const Count& b) {
    for (std::size_t i = 0; i < a.classes.size(); ++i) a.classes[i] += b.classes[i];
    zproof::add(a.edges, b.edges);
    a.reference_defects += b.reference_defects;
    a.adjudicated += b.adjudicated;
    a.exact += b.exact;
    return a;
}

/// What a verdict has the evidence of.
enum class Listed { failing, differing };

/// The findings of pixels that were ruled on.
class Record {
  public:
    Record(const Comparands& of, const OpenTiles& open, Listed listed)
        : of_(of), open_(open), listed_(listed) {}

    /// Writes classes of the verdict, whose size is set; and where all are listed its findings, each to its
    /// place.
    Count write(std::span<const PixelPlace> ruled, const Rulings& rulings, Verdict& verdict) const {
        using Pixels = tbb::blocked_range<std::size_t>;
        const auto write_some = [&](const Pixels& some, Count sum) {
            PixelLook look(of_.scene, of_.candidate, of_.reference);
            for (std::size_t i = some.begin(); i < some.end(); ++i) {
                const PixelPlace at = ruled[i];
                const Ruling ruling = rulings[i];
                const bool is_brief = listed_ == Listed::failing && open_.is_lawful(at);
                OpenPixel pixel = is_brief ? OpenPixel{} : look.at(at.x, at.y);
                finish(pixel, ruling);
                verdict.classes.in_open(at.x, at.y) = pixel.finding.verdict;
                sum.add(pixel, is_brief || differ(pixel.finding), ruling);
                if (listed_ == Listed::differing) verdict.findings[open_.number_of(at)] = pixel.finding;
            }
            return sum;
        };
        return tbb::parallel_reduce(Pixels(0, ruled.size(), 1024), Count{}, write_some,
                                    [](const Count& a, const Count& b) { return a + b; });
    }

    /// The findings of pixels that fail, once classes are written.
    Bulk<Finding> failing(std::span<const PixelPlace> ruled, const Rulings& rulings,
                          const ClassMap& classes) const {
        std::vector<std::size_t> failing;
        for (std::size_t i = 0; i < ruled.size(); ++i)
            if (!passes(classes.at(ruled[i].x, ruled[i].y))) failing.push_back(i);
        tbb::parallel_sort(failing,
                           [&](std::size_t a, std::size_t b) { return in_raster(ruled[a], ruled[b]); });
        Bulk<Finding> findings(failing.size());
        using Places = tbb::blocked_range<std::size_t>;
        tbb::parallel_for(Places(0, failing.size(), 1024), [&](const Places& some) {
            PixelLook look(of_.scene, of_.candidate, of_.reference);
            for (std::size_t k = some.begin(); k < some.end(); ++k) {
                const PixelPlace at = ruled[failing[k]];
                OpenPixel pixel = look.at(at.x, at.y);
                finish(pixel, rulings[failing[k]]);
                findings[k] = pixel.finding;
            }
        });
        return findings;
    }

  private:
    static void finish(OpenPixel& pixel, const Ruling& ruling) {
        pixel.finding.verdict = class_of(pixel, ruling);
        pixel.finding.eps_px = ruling.candidate.eps_px;
    }
    static bool differ(const Finding& finding) {
        return finding.candidate.primitive != finding.reference.primitive;
    }

    const Comparands& of_;
    const OpenTiles& open_;
    Listed listed_;
};

/// To findings that lack it: the square that the candidate's answer was judged in.
void add_squares(const Comparands& of, std::span<Finding> findings) {
    std::vector<Finding*> lacking;
    for (Finding& finding : findings)
        if (std::isnan(finding.eps_px)) lacking.push_back(&finding);
    if (lacking.empty()) return;
    std::vector<PixelPlace> places;
    places.reserve(lacking.size());
    for (const Finding* finding : lacking) places.push_back({finding->x, finding->y});
    const Rulings rulings = rule_on(of.scene, of.view, of.candidate, of.reference, places);
    for (std::size_t i = 0; i < lacking.size(); ++i) lacking[i]->eps_px = rulings[i].candidate.eps_px;
}

std::vector<RuledPlace> placed(std::span<const PixelPlace> places, const Rulings& rulings) {
    std::vector<RuledPlace> ruled;
    ruled.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [ours, theirs] = rulings[i];
        ruled.push_back(
            {places[i].x, places[i].y, ours.decision, theirs.decision, ours.eps_px, theirs.eps_px});
    }
    return ruled;
}

/// A renderer on trial, and whom it is held against.
struct Parties {
    const Testimony &candidate, &reference;
};

Verdict judge(const Scene& scene, const View& view, const Parties& parties, Depths depths,
              JudgedInFull* full) {
    const auto& [candidate, reference] = parties;
    const Resolution size{view.width, view.height};
    if (candidate.frame.size() != size || reference.frame.size() != size)
        throw std::invalid_argument("judge: both frames must have the view's size");
    Verdict verdict;
    const Witness ours(scene, view, candidate), theirs(scene, view, reference);
    const Comparands comparands{scene, view, ours, theirs};
    OpenTiles open = first_pass(comparands, {verdict, depths, full});
    const std::size_t open_count = open.count();
    verdict.classes = room_for(open, size);
    if (full) {
        open.number();
        verdict.findings.resize(open_count);
    }
    const ClassCounts layered = settle_layers(comparands, open, verdict.classes, verdict.findings);
    Bulk<PixelPlace> left = open.left();
    if (full) tbb::parallel_sort(left, in_raster);
    const Asked asked = full ? Asked::standing_and_displacement : Asked::without_square;
    const Rulings rulings = rule_on(scene, view, ours, theirs, left, asked);
    if (full) full->rulings = placed(left, rulings);
    const Record record(comparands, open, full ? Listed::differing : Listed::failing);
    Count count = record.write(left, rulings, verdict);
    count.add(layered);
    verdict.counts = count.classes;
    verdict.counts[std::size_t(PixelClass::agree)] += size.pixel_count() - open_count;
    verdict.candidate_edges = count.edges.candidate;
    verdict.reference_edges = count.edges.reference;
    verdict.reference_defects = count.reference_defects;
    verdict.adjudicated = count.adjudicated;
    verdict.exact = count.exact;
    if (!full && defect_count(verdict) != 0) {
        verdict.findings = record.failing(left, rulings, verdict.classes);
        add_squares(comparands, verdict.findings);
    } else if (full && count.classes[std::size_t(PixelClass::agree)] != 0) {
        std::erase_if(verdict.findings, [](const Finding& f) { return f.verdict == PixelClass::agree; });
    }
    return verdict;
}

}  // namespace

Verdict judge(const Scene& scene, const View& view, const Testimony& candidate, const Testimony& reference) {
    return judge(scene, view, {candidate, reference}, Depths::largest, nullptr);
}

Verdict judge_with_histograms(const Scene& scene, const View& view, const Testimony& candidate,
                              const Testimony& reference) {
    return judge(scene, view, {candidate, reference}, Depths::histograms, nullptr);
}

JudgedInFull judge_in_full(const Scene& scene, const View& view, const Testimony& candidate,
                           const Testimony& reference) {
    const Resolution size{view.width, view.height};
    JudgedInFull judged{{}, {Plane<float>::unwritten(size), Plane<float>::unwritten(size)}, {}};
    judged.verdict = judge(scene, view, {candidate, reference}, Depths::histograms, &judged);
    return judged;
}

std::uint64_t defect_count(const Verdict& verdict) {
    std::uint64_t defects = 0;
    for (int c = 0; c < pixel_class_count; ++c)
        if (!passes(PixelClass(c))) defects += verdict.counts[std::size_t(c)];
    return defects;
}

}  // namespace zproof
