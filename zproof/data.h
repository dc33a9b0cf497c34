/// What the objects of the public interface hold.
#pragma once

#include <mutex>
#include <optional>

#include "compare/verdict.h"
#include "frame/precision.h"
#include "oracle/embree.h"
#include "scenes/scene.h"
#include "scenes/triangle_labels.h"
#include "scenes/view.h"
#include "zproof/zproof.h"

namespace zproof::api {

struct View::Data {
    zproof::View view;
};

struct Scene::Data {
    zproof::Scene scene;
    std::vector<View> views;

    /// Built when it is first asked for.
    const oracle::Embree& embree() const {
        const std::scoped_lock lock{mutex_};
        if (!embree_) embree_.emplace(scene);
        return *embree_;
    }

  private:
    mutable std::mutex mutex_;
    mutable std::optional<oracle::Embree> embree_;
};

struct Frame::Data {
    zproof::Frame frame;
};

/// How a candidate was declared.
struct Declared {
    std::string precision_word, ids;
    Precision precision;
    std::shared_ptr<const TriangleLabels> labels;  ///< nothing: triangles
    bool has_depth = true;
};

struct Verdict::Data {
    Scene scene;
    View view;
    Declared declared;
    zproof::Frame given;   ///< as the candidate gave it; lent
    zproof::Frame judged;  ///< of triangles
    Frame reference;
    zproof::Verdict verdict;
    std::vector<Finding> findings;
};

}  // namespace zproof::api
