#include "filters/commands/pictures.h"

#include <algorithm>
#include <chrono>

#include "filters/report/folder.h"
#include "frame/frame_error.h"
#include "oracle/convention/stored_frame.h"
#include "oracle/external.h"
#include "oracle/oracle_error.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr std::chrono::minutes time_limit{10};

bool is_safe(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
}

bool names(const std::string& word, const std::string& place) {
    return word.find(place) != std::string::npos;
}

std::string replaced(std::string text, const std::string& place, const std::string& meaning) {
    for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += meaning.size())
        text.replace(at, place.size(), meaning);
    return text;
}

Picture drawn(const PictureChoice& choice, const Scene& scene, const View& view) try {
    if (choice.is_program()) return oracle::External(scene, choice.word, time_limit).render_picture(view);
    const std::string file = replaced(replaced(choice.word, "{scene}", scene.name), "{view}", view.name);
    return picture_in(file, view);
} catch (const OracleError& e) {
    throw study::RendererFailure{e.what()};
} catch (const FrameError& e) {
    throw study::RendererFailure{e.what()};
}

/// "; claims to be of trilinear-gl, promising gpu"; nothing without a claim.
std::string claim_in_words(const std::optional<PictureClaim>& claim) {
    if (!claim) return "";
    return "; claims to be of " + claim->method.typed +
           (claim->promise.empty() ? "" : ", promising " + claim->promise);
}

texture::DefinitionCard card_of(const PictureChoice& choice) {
    const std::string unknown = "not known: a picture of another renderer.";
    return {.footprint = unknown,
            .lod = unknown,
            .taps = unknown,
            .source = (choice.is_program() ? "written by: " : "read from: ") + choice.word +
                      claim_in_words(choice.claim)};
}

}  // namespace

PictureChoice picture_choice(const std::string& typed) {
    const std::size_t equals = typed.find('=');
    PictureChoice choice{typed.substr(0, equals),
                         equals == std::string::npos ? "" : typed.substr(equals + 1)};
    if (choice.name.empty() || choice.word.empty())
        throw UsageError{"--picture: expected NAME=FILE or NAME='COMMAND {scene} {camera} {out}', found '" +
                         typed + "'"};
    if (!std::ranges::all_of(choice.name, is_safe))
        throw UsageError{"--picture: '" + choice.name +
                         "': a name has letters, digits, '-', '_' and '.' only"};
    return choice;
}

void add_claims(std::vector<PictureChoice>& pictures, const ClaimWords& words) {
    if (words.claims.empty() && words.precision)
        throw UsageError{"--precision: expected together with --claim NAME=METHOD"};
    for (const std::string& typed : words.claims) {
        const std::size_t equals = typed.find('=');
        const auto picture = std::ranges::find(pictures, typed.substr(0, equals), &PictureChoice::name);
        if (equals == std::string::npos || picture == pictures.end())
            throw UsageError{"--claim: expected NAME=METHOD with the name of a --picture, found '" + typed +
                             "'"};
        if (picture->claim) throw UsageError{"--claim: '" + picture->name + "' has a claim already"};
        const FilterChoice method = filter_choice(typed.substr(equals + 1));
        picture->claim = PictureClaim{method, words.promise, claim_of(method, words.precision)};
    }
}

const PictureClaim* find_claim(const std::vector<PictureChoice>& pictures, const std::string& name) {
    const auto picture = std::ranges::find(pictures, name, &PictureChoice::name);
    return picture != pictures.end() && picture->claim ? &*picture->claim : nullptr;
}

void refuse_equal_names(const std::vector<PictureChoice>& pictures, const std::vector<std::string>& methods) {
    std::vector<std::string> taken{"truth", "surface"};
    for (const std::string& method : methods) taken.push_back(file_stem(method));
    for (const PictureChoice& picture : pictures) {
        if (std::ranges::find(taken, picture.name) != taken.end() || picture.name.ends_with("-error") ||
            picture.name.ends_with("-permitted"))
            throw UsageError{"--picture: the name '" + picture.name + "' is taken; choose another one"};
        taken.push_back(picture.name);
    }
}

void require_a_file_for_each(const std::vector<PictureChoice>& pictures, std::size_t scenes,
                             std::size_t views) {
    const auto require = [](const PictureChoice& picture, const std::string& what, std::size_t count) {
        const std::string place = "{" + what + "}";
        if (count > 1 && !picture.is_program() && !names(picture.word, place))
            throw UsageError{"--picture: " + picture.name + ": one file for " + std::to_string(count) + " " +
                             what + "s; put " + place + " into its name, or choose one " + what};
    };
    for (const PictureChoice& picture : pictures) {
        require(picture, "scene", scenes);
        require(picture, "view", views);
    }
}

Picture picture_in(const std::filesystem::path& file, const View& view) {
    return oracle::read_stored_picture(file, view, time_limit);
}

study::StudyMethod study_method(const PictureChoice& choice) {
    using Views = study::StudyMethod::Views;
    return {.label = choice.name,
            .texturing = {.method = {choice.name, card_of(choice), {}}},
            .paint = [choice](const Scene& scene, const View& view,
                              const Frame&) { return drawn(choice, scene, view); },
            .views = choice.is_program() ? Views::panned : Views::still};
}

}  // namespace zproof
