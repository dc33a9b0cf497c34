#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ostream>
#include <span>
#include <string>

#include "reports/evidence.h"

namespace zproof {

namespace {

/// Appends a cell and its comma. Numbers are the shortest that read back to the same bits.
template <class Number>
void add(std::string& text, Number value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end) += ',';
}

/// to_chars would tell -nan apart.
template <class Real>
void add_real(std::string& text, Real value) {
    if (std::isnan(value))
        text += "nan,";
    else
        add(text, value);
}

void add(std::string& text, PrimitiveId id) {
    if (id == PrimitiveId::none)
        text += "none,";
    else
        add(text, static_cast<std::uint32_t>(id));
}

void add_row(std::string& text, const Finding& f) {
    add(text, f.x);
    add(text, f.y);
    text.append(name_of(f.verdict)) += ',';
    add(text, f.candidate.primitive);
    add(text, f.reference.primitive);
    add_real(text, f.candidate.camera_depth);
    add_real(text, f.reference.camera_depth);
    for (const double value : {f.eps_px, f.candidate_depth.low, f.candidate_depth.truth,
                               f.candidate_depth.high, f.error_over_bound})
        add_real(text, value);
    text.back() = '\n';
}

/// A piece of the file, made by one thread; a wave of them is in memory at a time.
constexpr std::size_t rows_in_piece = 1024, pieces_in_wave = 64;

void write_wave(std::ostream& out, std::span<const Finding> findings) {
    std::array<std::string, pieces_in_wave> pieces;
    tbb::parallel_for(std::size_t{0}, (findings.size() + rows_in_piece - 1) / rows_in_piece,
                      [&](std::size_t i) {
                          const auto rows = findings.subspan(i * rows_in_piece);
                          for (const Finding& f : rows.first(std::min(rows.size(), rows_in_piece)))
                              add_row(pieces[i], f);
                      });
    for (const std::string& piece : pieces) out << piece;
}

}  // namespace

void write_findings(std::ostream& out, const Verdict& verdict) {
    out << "x,y,class,candidate_id,reference_id,candidate_depth,reference_depth,eps_px,depth_low,depth_truth,"
           "depth_high,error_over_bound\n";
    constexpr std::size_t wave = rows_in_piece * pieces_in_wave;
    for (std::span<const Finding> rest = verdict.findings; !rest.empty();
         rest = rest.subspan(std::min(rest.size(), wave)))
        write_wave(out, rest.first(std::min(rest.size(), wave)));
}

}  // namespace zproof
