#include <algorithm>
#include <cmath>
#include <map>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/renamed_ids.h"
#include "frame/number_text.h"

namespace zproof {

namespace {

/// Each label of the scene with one of its triangles.
std::map<std::uint32_t, PrimitiveId> one_triangle_each(const TriangleLabels& labels) {
    std::map<std::uint32_t, PrimitiveId> triangles;
    for (std::size_t t = 0; t < labels.of_triangle.size(); ++t)
        triangles.emplace(labels.of_triangle[t], PrimitiveId(t));
    return triangles;
}

/// The hypothesis that meant(label) is meant by a label; nothing: by a label that means none.
Hypothesis with_labels(const DiagnosisInput& input, Cause cause,
                       std::function<std::optional<std::uint32_t>(std::uint32_t)> meant) {
    Hypothesis h = as_declared(input, std::move(cause));
    h.restate = [meant = std::move(meant), triangles = one_triangle_each(input.said->labels),
                 &labels = input.said->labels](Claim claim) -> std::optional<Claim> {
        const std::optional<std::uint32_t> label = meant(std::uint32_t(claim.label));
        if (!label) return std::nullopt;
        const auto found = triangles.find(*label);
        const bool is_background = std::ranges::count(labels.background, *label) > 0;
        if (!is_background && found == triangles.end()) return std::nullopt;
        claim.answer.primitive = is_background ? PrimitiveId::none : found->second;
        return claim;
    };
    return h;
}

/// The labels that the reference sees.
std::vector<PrimitiveId> right_labels(const DiagnosisInput& input) {
    std::vector<PrimitiveId> right;
    for (const PrimitiveId id : input.reference.frame.primitive.pixels())
        right.push_back(label_of(input.said->labels, id));
    return right;
}

/// "0 and 1", "7 instead of 0, 9 instead of 1", at most three of them.
std::string renamed_text(const std::map<std::uint32_t, std::uint32_t>& meant) {
    std::string text;
    std::size_t told = 0;
    for (const auto& [said, label] : meant) {
        if (told++ == 3) return text + ", ...";
        text += (text.empty() ? "" : ", ") + std::to_string(said) + " instead of " + std::to_string(label);
    }
    return text;
}

/// Each label stands for the one that the reference has most often in its place, as far as no two do.
std::vector<Hypothesis> renamed(const DiagnosisInput& input) {
    const std::vector<PrimitiveId> right = right_labels(input);
    const auto said = input.said->ids.pixels();
    const Ids there = most_often_with(said, right), back = most_often_with(right, said);
    std::map<std::uint32_t, std::uint32_t> changed;
    for (const auto& [label, other] : there)
        if (label != other && back.at(other) == label) changed.emplace(label, other);
    if (changed.empty()) return {};
    const bool is_exchange = std::ranges::all_of(changed, [&](const auto& pair) {
        const auto other = changed.find(pair.second);
        return other != changed.end() && other->second == pair.first;
    });
    Hypothesis h = with_labels(
        input,
        {is_exchange ? "labels are exchanged" : "labels have other numbers",
         "A label stands for another wherever it occurs: " + renamed_text(changed) + ".",
         is_exchange ? "Look at the order in which objects or materials are numbered."
                     : "Look at where labels come from: the file, the names that are hashed, the export."},
        [changed, back](std::uint32_t label) -> std::optional<std::uint32_t> {
            const auto found = changed.find(label);
            if (found != changed.end()) return found->second;
            const auto other = back.find(label);  // another number stands for this one
            const bool is_renamed = other != back.end() && changed.contains(other->second);
            return is_renamed ? std::nullopt : std::optional(label);
        });
    h.learned_bits = 2 * double(changed.size()) * bits_of_an_id(input);
    h.tells_numbers = true;
    return {h};
}

/// told(label) is written instead of a label.
Hypothesis told_as(const DiagnosisInput& input, Cause cause, const Renamed& told) {
    std::map<std::uint32_t, std::uint32_t> meant;
    for (const auto& [label, triangle] : one_triangle_each(input.said->labels))
        meant.emplace(told(label), label);
    return with_labels(input, std::move(cause), [meant](std::uint32_t label) -> std::optional<std::uint32_t> {
        if (label == nobody) return label;
        const auto found = meant.find(label);
        return found == meant.end() ? std::nullopt : std::optional(found->second);
    });
}

std::vector<Hypothesis> of_numbers(const DiagnosisInput& input) {
    const char* counter = "Look at where labels are numbered: they count from 0.";
    std::vector<Hypothesis> all{
        told_as(input, {"labels count from 1", "A label is one too large.", counter},
                [](std::uint32_t label) { return label + 1; }),
        with_labels(input,
                    {"labels count from 1, and 0 is background",
                     "A label is one too large, and 0 where nothing is seen.", counter},
                    [](std::uint32_t label) -> std::optional<std::uint32_t> {
                        if (label == nobody) return std::nullopt;
                        return label - 1;
                    }),
        told_as(input, {"labels are too small by one", "A label is one too small, 0 for 0.", counter},
                [](std::uint32_t label) { return label == 0 ? 0 : label - 1; })};
    for (const ByteCurve& curve : byte_curves()) all.push_back(told_as(input, curve.cause("labels"), curve));
    return all;
}

/// What a candidate without ids says where nothing is seen: the depth that it has there most often.
std::vector<Hypothesis> of_background(const DiagnosisInput& input) {
    std::map<float, std::size_t> times;
    std::size_t not_numbers = 0;
    const auto seen = input.reference.frame.primitive.pixels();
    const auto told = input.candidate.frame.camera_depth.pixels();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i] != PrimitiveId::none || told[i] == background_depth) continue;
        if (std::isnan(told[i]))
            ++not_numbers;
        else
            ++times[told[i]];
    }
    const auto most = std::ranges::max_element(times, {}, [](const auto& pair) { return pair.second; });
    const bool is_nan = not_numbers > 0 && (most == times.end() || not_numbers >= most->second);
    if (!is_nan && most == times.end()) return {};
    const float depth = is_nan ? std::numeric_limits<float>::quiet_NaN() : most->first;
    Hypothesis h = as_declared(
        input,
        {"background has a depth",
         "Where nothing is seen, the depth is " + (is_nan ? "not a number" : with_digits(depth, 6)) +
             " instead of +infinity.",
         "Look at the depth buffer's clear value and at how it is turned back: background is +infinity."});
    h.learned_bits = bits_of_a_number;
    h.tells_numbers = true;
    h.restate = [depth, is_nan](Claim claim) -> std::optional<Claim> {
        const float own = claim.answer.camera_depth;
        if (own == background_depth) return std::nullopt;
        if (is_nan ? std::isnan(own) : own == depth) claim.answer = {PrimitiveId::none, background_depth};
        return claim;
    };
    return {h};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_labels(const DiagnosisInput& input) {
    if (input.said->labels.are_absent) return of_background(input);
    std::vector<Hypothesis> all = of_numbers(input);
    for (const Hypothesis& h : renamed(input)) all.push_back(h);
    return all;
}

}  // namespace zproof
