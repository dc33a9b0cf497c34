/// Pictures of anybody's renderer in a study: NAME=FILE or NAME='program {scene} {camera} {out}'.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/filters/plan.h"

namespace zproof {

struct PictureChoice {
    std::string name;
    /// A file (.exr), in whose name {scene} and {view} stand for theirs; or with {out} in it, a command by
    /// the contract of docs/renderer-contract.md that writes a picture.
    std::string word;

    bool is_program() const { return word.find("{out}") != std::string::npos; }
};

/// Throws UsageError where it is not NAME=WORD, or the name is no file name.
PictureChoice picture_choice(const std::string& typed);

/// Throws UsageError where two pictures, or a picture and another file of the study, would have one name.
void refuse_equal_names(const std::vector<PictureChoice>& pictures, const std::vector<std::string>& methods);

/// Throws UsageError where files are named alike for several scenes, or several views of one.
void require_a_file_for_each(const std::vector<PictureChoice>& pictures, std::size_t scenes,
                             std::size_t views);

/// The picture as a method of the study. It throws study::RendererFailure where there is none.
study::ConfiguredMethod configured(const PictureChoice& choice);

}  // namespace zproof
