/// Pictures of anybody's renderer in a study: NAME=FILE or NAME='program {scene} {camera} {out}', and what
/// they claim to be.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "filters/commands/claim.h"
#include "filters/study/plan.h"

namespace zproof {

struct PictureChoice {
    std::string name;
    /// A file (.exr), in whose name {scene} and {view} stand for theirs; or with {out} in it, a command by
    /// the contract of docs/renderer-contract.md that writes a picture.
    std::string word;
    std::optional<PictureClaim> claim{};  ///< none: it is held to the truth alone

    bool is_program() const { return word.find("{out}") != std::string::npos; }
};

/// Throws UsageError where it is not NAME=WORD, or the name is no file name.
PictureChoice picture_choice(const std::string& typed);

/// What pictures claim, as it is typed.
struct ClaimWords {
    std::vector<std::string> claims;           ///< NAME=METHOD each
    std::string promise;                       ///< of all claims; empty: none was typed
    std::optional<FilterPrecision> precision;  ///< that promise; none: that of zproof's own filters
};

/// Tells each claim to the picture of its name. Throws UsageError where there is no such picture, it has a
/// claim already, or its method has no filter reference; and for a promise without a claim.
void add_claims(std::vector<PictureChoice>& pictures, const ClaimWords& words);

/// What the picture of that name claims; null where nothing of that name claims anything.
const PictureClaim* find_claim(const std::vector<PictureChoice>& pictures, const std::string& name);

/// Throws UsageError where two pictures, or a picture and another file of the study, would have one name.
void refuse_equal_names(const std::vector<PictureChoice>& pictures, const std::vector<std::string>& methods);

/// Throws UsageError where files are named alike for several scenes, or several views of one.
void require_a_file_for_each(const std::vector<PictureChoice>& pictures, std::size_t scenes,
                             std::size_t views);

/// Somebody's picture of that view. Throws FrameError where it cannot be read or is of another size.
Picture picture_in(const std::filesystem::path& file, const View& view);

/// The picture as a method of the study. It throws study::RendererFailure where there is none.
study::StudyMethod study_method(const PictureChoice& choice);

}  // namespace zproof
