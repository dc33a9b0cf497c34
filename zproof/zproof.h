/// zproof for programs: a scene, a view, what should be seen in it, and whether somebody's frame shows that.
///
/// This header and zproof/filters.h are the public interface (docs/api.md); they keep to semantic versioning.
/// They need the standard library alone. All objects are cheap to copy and share what they hold, which never
/// changes: any number of threads may use them. Work runs on all cores, or on those of the surrounding
/// tbb::task_arena, and the result does not depend on their number.
///
/// Conventions: right-handed, y up, the camera looks down -z; raster x runs right and y down, row 0 at the
/// top; pixel (x, y) is sampled at (x + 1/2, y + 1/2). Planes are row-major, width * height values. Depth is
/// the distance along the view axis in scene units; background has id `background_id` and depth +infinity.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace zproof::api {

inline constexpr std::uint32_t background_id = 0xFFFF'FFFF;

/// What the caller handed over cannot be used: the message says what came and what is expected. Whatever else
/// goes wrong (a file cannot be written, Embree cannot be started) is another std::runtime_error.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The largest side of pictures and textures.
inline constexpr int largest_side = 32768;

/// In pixels, 1 to largest_side on either side.
struct Size {
    int width = 0, height = 0;

    std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
    bool operator==(const Size&) const = default;
};

/// A camera and a picture's size: what a renderer is asked to draw.
class View {
  public:
    /// What the named constructors have in common.
    struct Placed {
        std::array<double, 3> eye{}, target{}, up{0, 1, 0};  ///< world space; the eye is rounded to float32
        double near_depth = 0.1, far_depth = std::numeric_limits<double>::infinity();
        Size size;
        std::string name = "view";  ///< letters, digits, '-', '_', and '.' but at the beginning
    };
    /// A symmetric perspective: yfov in radians, (0, pi). Throws InputError.
    static View perspective(const Placed& placed, double yfov);
    /// An orthographic view of a window `height` scene units high; far must be finite. Throws InputError.
    static View orthographic(const Placed& placed, double height);

    /// A camera by OpenCV's conventions: x right, y down, z forward; p_camera = R p_world + t, and the centre
    /// of the top left pixel is at (0, 0) of the image that K maps to. Matrices by rows.
    struct OpenCv {
        std::array<double, 9> K{}, R{1, 0, 0, 0, 1, 0, 0, 0, 1};
        std::array<double, 3> t{};
    };
    /// K's skew must be 0. R must be a rotation to within 1e-5, as float32 holds one; the nearest rotation in
    /// double is taken. The eye is rounded to float32. Ask opencv() for what is judged exactly, and give that
    /// to the renderer. Source: OpenCV, Camera Calibration and 3D Reconstruction. Throws InputError.
    static View from_opencv(const OpenCv& camera, Size size, double near_depth, double far_depth,
                            std::string name = "view");

    const std::string& name() const;
    Size size() const;
    double near_depth() const;
    double far_depth() const;
    bool is_perspective() const;
    /// The exact camera in OpenCV's conventions. Throws InputError for a parallel projection.
    OpenCv opencv() const;

    /// Matrices by rows, for column vectors, in double.
    struct Matrices {
        std::array<double, 16> camera_from_world, clip_from_camera;  ///< OpenGL's clip space, z in [-w, w]
    };
    Matrices matrices() const;

    struct Data;
    explicit View(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
    const Data& data() const { return *data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// Triangles of one material.
struct Mesh {
    std::span<const float> positions_world;    ///< 3 per vertex; float32 is exact from here on
    std::span<const std::uint32_t> triangles;  ///< 3 vertex indices each; triangle i has id i
    std::span<const float> uv{};               ///< 2 per vertex, or empty
    /// An sRGB texture that repeats, RGBA with 8 bits, row 0 first; or none. Needs uv.
    std::span<const std::uint8_t> texels{};
    Size texture_size{};
    std::string name = "scene";  ///< as a view's
};

/// Triangles in world space; a triangle's index is its id.
class Scene {
  public:
    /// Copies the mesh. Throws InputError for lengths that do not fit, an index beyond the vertices, and
    /// positions that are not judged (NaN, infinity, beyond 1e11).
    explicit Scene(const Mesh& mesh);
    /// A .gltf, .glb, .obj or .ply file, a view file (.json, docs/view-file.md), or the name of a scene of
    /// the suite. `size` is that of the views where the file names none. Throws InputError.
    static Scene load(const std::string& file_or_name, Size size = {1920, 1080});

    const std::string& name() const;
    std::size_t vertex_count() const;
    std::size_t triangle_count() const;
    std::span<const float> positions_world() const;    ///< 3 per vertex
    std::span<const std::uint32_t> triangles() const;  ///< 3 per triangle
    const std::vector<View>& views() const;            ///< that the file gives; none of a mesh
    const std::vector<std::string>& notes() const;     ///< what loading left out, one line each

    struct Data;
    explicit Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
    const Data& data() const { return *data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// Writes FOLDER/NAME.glb, and FOLDER/NAME.view.json with the views, NAME being the scene's: what the program
/// and load() take, bit for bit. The folder must be there. Throws InputError where it cannot be written.
void save(const Scene& scene, std::span<const View> views, const std::string& folder);

/// Ids and depths of one view, of zproof's own renderers.
class Frame {
  public:
    Size size() const;
    std::span<const std::uint32_t> id() const;
    std::span<const float> depth() const;

    struct Data;
    explicit Frame(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
    const Data& data() const { return *data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// zproof's own z-buffer rasterizer: float64 transform, 8 sub-pixel bits. Throws InputError for a view that
/// is not judged.
Frame render(const Scene& scene, const View& view);
/// Embree: a ray through each pixel's centre. Throws as render() does.
Frame trace(const Scene& scene, const View& view);

/// What a renderer gave, and what it promises.
struct Candidate {
    std::span<const std::uint32_t> id{};  ///< empty: depth alone is judged (docs/labels.md)
    std::span<const float> depth{};       ///< empty: ids alone are judged
    /// A preset's name (docs/presets.md), "raster,subpixel_bits=4", or a file (docs/renderer-contract.md).
    std::string precision{};
    /// What its ids stand for: "triangle", or coarser: "material", "node" ... (docs/labels.md).
    std::string ids = "triangle";
};

/// The classes' names by their number, which Verdict::classes() holds: "agree", "edge" ...
std::span<const std::string_view> class_names();
/// 0xRRGGBB, by the same number; the report's colours.
std::span<const std::uint32_t> class_colours();
/// Does a pixel of this class fail the gate?
bool is_defect(std::uint32_t pixel_class);

/// A pixel that does not simply agree. Plain numbers, for arrays.
struct Finding {
    std::int32_t x, y;
    std::uint32_t pixel_class;
    std::uint32_t is_defect;  ///< 1: fails the gate; else 0
    std::uint32_t candidate_id, reference_id;
    float candidate_depth, reference_depth;
    double depth_low, depth_truth, depth_high;  ///< that the candidate's triangle admits; NaN: background
    double eps_px;                              ///< half-side of the square that the answer was judged in
    double error_over_bound;                    ///< of the candidate's depth; NaN: background
};

/// Its numbers by the names that arrays give them.
inline constexpr std::tuple finding_fields{
    std::pair{"x", &Finding::x},
    std::pair{"y", &Finding::y},
    std::pair{"class", &Finding::pixel_class},
    std::pair{"is_defect", &Finding::is_defect},
    std::pair{"id", &Finding::candidate_id},
    std::pair{"reference_id", &Finding::reference_id},
    std::pair{"depth", &Finding::candidate_depth},
    std::pair{"reference_depth", &Finding::reference_depth},
    std::pair{"depth_low", &Finding::depth_low},
    std::pair{"depth_truth", &Finding::depth_truth},
    std::pair{"depth_high", &Finding::depth_high},
    std::pair{"eps_px", &Finding::eps_px},
    std::pair{"error_over_bound", &Finding::error_over_bound},
};

/// Why a pixel has its class.
struct Explanation {
    Finding finding;
    std::string text;  ///< the story, several lines
    /// A triangle that comes near the pixel, nearest first.
    struct Triangle {
        std::uint32_t id;
        double depth_low, depth_truth, depth_high;
        std::array<double, 3> edge_distance_px;  ///< of the centre from each edge, positive inside
        bool is_admissible;
    };
    std::vector<Triangle> triangles;
    bool is_background_admissible;
};

/// What one cause would explain.
struct Diagnosis {
    std::string text;   ///< one line
    std::string cause;  ///< "the image is flipped in y"; empty: none is certain
    double explained_share = 0;
    std::uint64_t defects = 0;
};

/// What the judge says of a candidate's frame beside Embree's. It refers to the candidate's arrays.
class Verdict {
  public:
    bool is_proven() const;  ///< no defect, and nothing undecidable
    std::uint64_t defect_count() const;
    std::span<const std::uint64_t> counts() const;  ///< pixels by class
    std::span<const std::uint8_t> classes() const;  ///< of every pixel
    std::span<const Finding> findings() const;      ///< every pixel that is not `agree`, in raster order
    /// The defect with the largest error over its bound, as the report ranks them; nothing where there is
    /// none.
    std::optional<Finding> worst() const;
    std::string sentence(const Finding& finding) const;  ///< one line

    /// Throws InputError for a pixel outside of the view.
    Explanation explain(int x, int y) const;
    /// Nothing where there is no defect. Takes about as long as the verdict.
    std::optional<Diagnosis> diagnosis() const;

    const Scene& scene() const;
    const View& view() const;
    const Frame& reference() const;  ///< what Embree saw
    /// The frame that was judged: of triangles, where the candidate's ids are coarser.
    std::span<const std::uint32_t> judged_id() const;
    std::span<const float> judged_depth() const;

    struct Data;
    explicit Verdict(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
    const Data& data() const { return *data_; }

  private:
    std::shared_ptr<const Data> data_;
};

/// Judges arrays without a copy; they must outlive the verdict and stay as they are. Throws InputError for
/// lengths that are not the view's, and a precision or ids that are not known.
Verdict judge(const Scene& scene, const View& view, const Candidate& candidate);

/// Writes report.html, results.json and the evidence, as `zproof compare` does: by that program, which is
/// looked for on PATH, or is the one that the environment variable ZPROOF_PROGRAM names. What it was given
/// (scene, view, frame, a file of the precision) stays in FOLDER-input. The report's commands can be repeated
/// where both folders lie, also when they were moved. A folder that is no report of zproof is never replaced.
/// `name` is the scene's in the report; empty: its own. Throws std::runtime_error with the program's own
/// words, InputError for a name that is not usable.
void save(const Verdict& verdict, const std::string& folder, const std::string& name = "");

/// One report of many verdicts, and in FOLDER/NAME that of each. A name is its scene's in the report: as a
/// view's, without "-input" at its end, no two alike. As save().
struct NamedVerdict {
    std::string name;
    Verdict verdict;
};
void save(std::span<const NamedVerdict> verdicts, const std::string& folder);

/// "0.2.0".
std::string_view version();

}  // namespace zproof::api
