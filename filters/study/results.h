/// What a study of texture filters found, as plain values: everything that its reports show, and nothing that
/// computes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zproof::study {

/// A metric as the reports need it; filters/metrics/picture_metric.h computes it.
struct MetricCard {
    std::string name, definition, source;
    bool higher_is_better = false;
    int decimals = 4;
};

/// A method as it was asked for, and its three rules.
struct MethodCard {
    std::string label;  ///< as typed: NAME, or NAME:key=value
    std::string footprint, lod, taps, source;
};

/// A part of an image that methods are held to the truth on.
struct RegionScore {
    std::string region;
    std::uint64_t pixels = 0;
    double truth_half_width = 0;  ///< RMS of the truth's 95 % half widths; 0 where all of it is exact
    std::vector<double> values;   ///< by StudyResults::metrics; NaN where the region is empty
};

/// Per pixel, over the pixels that show a texture.
struct Cost {
    double texels = 0;               ///< stored values read
    double lines = 0;                ///< distinct 64-byte lines that hold them, were each image row-major
    std::uint64_t bytes_stored = 0;  ///< of all textures, as the method keeps them
    double build_ms = 0;             ///< from linear texels to what is stored
    double ns_per_sample = 0;        ///< a lookup, processor time of one thread
    std::uint64_t pixels = 0;        ///< that were counted
};

/// What moves although the truth does not, from view to view shifted by a fraction of a pixel.
struct Flicker {
    double rms = 0;  ///< of (change of the picture) - (change of the truth)
    double ratio =
        0;          ///< RMS change of the picture / of the truth: above 1 it shimmers, below 1 it is blurred
    int steps = 0;  ///< 0: not measured
};

/// What a picture claims to be, and what that method says of it, pixel by pixel.
struct ClaimCount {
    std::string method, promise;       ///< as typed; promise empty: that of zproof's own filters
    std::uint64_t pixels_outside = 0;  ///< of the whole picture: what the method does not permit
};

struct MethodScore {
    std::string label;
    std::vector<RegionScore> regions;  ///< the same regions, in the same order, for every method of a view
    Cost cost;
    Flicker flicker;
    std::string file;  ///< its picture, relative to the study's folder
    std::optional<ClaimCount> claim{};
};

/// A picture that is missing, and why.
struct MissingPicture {
    std::string label, reason;
};

struct ViewStudy {
    std::string scene, view, reason;
    int width = 0, height = 0;
    int first_row = 0;     ///< rows above it count in "all" and "horizon" only
    std::string textures;  ///< "512 x 512"
    std::vector<MethodScore> methods;
    std::string scene_sha256{};  ///< of the .glb that zproof writes of it
    std::string truth_file;
    double truth_seconds = 0;  ///< to compute the truth of one view
    std::vector<MissingPicture> missing{};
};

/// A definition of a region, for the legend.
struct RegionCard {
    std::string name, definition;
};

struct StudyResults {
    static constexpr const char* schema_version = "1.0";
    std::string version, commit, command, compiler;
    std::string processor, date;  ///< "AMD EPYC", "2026-11-26T18:09:00Z"
    std::string truth;            ///< "N" to "BH" (oracle::reconstructions)
    int threads = 0;
    double seconds = 0;
    bool is_complete = true;  ///< false: interrupted
    std::vector<MetricCard> metrics;
    std::vector<RegionCard> regions;
    std::vector<MethodCard> methods;
    std::vector<ViewStudy> views;
};

}  // namespace zproof::study
