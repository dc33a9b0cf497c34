#include "filters/commands/study_method.h"

#include "oracle/oracle_error.h"

namespace zproof {

study::StudyMethod study_method(const FilterChoice& choice) {
    study::StudyMethod method{choice.typed, choice.texturing};
    if (choice.other == nullptr) return method;
    if (const std::string absence = choice.other->absence(); !absence.empty())
        throw OracleError{choice.typed + ": " + absence};
    method.paint = [paint = choice.other->paint, options = choice.texturing.options](
                       const Scene& scene, const View& view, const Frame& frame) {
        return paint(scene, view, frame, options);
    };
    return method;
}

}  // namespace zproof
