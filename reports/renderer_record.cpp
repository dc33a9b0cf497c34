#include "reports/renderer_record.h"

#include <algorithm>

namespace zproof {

namespace {

std::uint64_t pixels_of(const ViewResult& v) { return std::uint64_t(v.width) * std::uint64_t(v.height); }

/// Judged on its own merits? A view whose required oracle is missing was, too: its counts are there.
bool has_id_agreement(const ViewResult& v) { return !v.id_agreement.same.empty(); }

class Records {
  public:
    RendererRecord& of(const std::string& name, const std::string& role) {
        const auto found = std::ranges::find_if(
            records_, [&](const RendererRecord& r) { return r.name == name && r.role == role; });
        if (found != records_.end()) return *found;
        return records_.emplace_back(RendererRecord{.name = name, .role = role, .absent = {}});
    }

    std::vector<RendererRecord> take() { return std::move(records_); }

  private:
    std::vector<RendererRecord> records_;
};

/// What one view adds to a renderer's record.
struct Share {
    std::uint64_t defects;
    double depth_error_over_bound, edge_error_over_bound;
    std::uint64_t unlike_candidate;
    std::optional<SampledPixels> sample{};
};

/// Pixels that everybody was asked about.
std::uint64_t compared_pixels(const ViewResult& v) { return v.id_agreement.same[0][0]; }

std::uint64_t unlike_candidate(const ViewResult& v, std::size_t place) {
    return compared_pixels(v) - v.id_agreement.same[0][place];
}

void add(RendererRecord& record, const ViewResult& v, const Share& share) {
    ++record.views;
    record.of_pixels += pixels_of(v);
    record.pixels += share.sample ? share.sample->pixels : pixels_of(v);
    if (share.sample) record.seed = share.sample->seed;
    record.defects += share.defects;
    record.depth_error_over_bound = std::max(record.depth_error_over_bound, share.depth_error_over_bound);
    record.edge_error_over_bound = std::max(record.edge_error_over_bound, share.edge_error_over_bound);
    record.unlike_candidate += share.unlike_candidate;
}

void add_not_compared(RendererRecord& record, const std::string& why) {
    ++record.not_compared;
    if (record.absent.empty()) record.absent = why;
}

void add_oracles(Records& records, const ViewResult& v) {
    std::size_t place = 2;  // in the id agreement, after candidate and reference
    for (const OracleResult& w : v.oracles) {
        RendererRecord& record = records.of(w.name, "oracle");
        if (!w.absent.empty())
            add_not_compared(record, w.absent);
        else
            add(record, v,
                {defect_count(w.counts), w.depth.max_error_over_bound, w.edges.max_error_over_bound,
                 unlike_candidate(v, place++), w.sample});
    }
}

}  // namespace

std::vector<RendererRecord> renderer_records(const Results& results) {
    Records records;
    for (const ViewResult& v : results.views) {
        if (!has_id_agreement(v)) continue;
        add(records.of(v.candidate, "candidate"), v,
            {defect_count(v), v.candidate_depth.max_error_over_bound, v.candidate_edges.max_error_over_bound,
             0});
        add(records.of(v.reference, "reference"), v,
            {v.reference_defects, v.reference_depth.max_error_over_bound,
             v.reference_edges.max_error_over_bound, unlike_candidate(v, 1)});
        add_oracles(records, v);
    }
    return records.take();
}

Unanimity unanimity(const Results& results) {
    Unanimity sum;
    for (const ViewResult& v : results.views)
        if (has_id_agreement(v))
            sum = {sum.pixels + compared_pixels(v), sum.unanimous + v.id_agreement.unanimous};
    return sum;
}

}  // namespace zproof
