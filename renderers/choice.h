/// Which renderer is meant, before it has met a scene.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "frame/precision.h"
#include "oracle/vulkan.h"
#include "scenes/sample.h"

namespace zproof {

class KeptInput;

/// One of those that zproof knows by name: see renderer_names().
struct BuiltIn {
    std::string name;
    oracle::VulkanSettings vulkan{};  ///< of the renderer of that name
};

/// Somebody's program (docs/renderer-contract.md).
struct Program {
    std::string command;  ///< for a shell, with {scene}, {camera}, {width}, {height}, {out}
};

/// A frame that was rendered elsewhere and stands for its renderer.
struct StoredFrame {
    std::filesystem::path file;  ///< as oracle::read_stored_frame() takes it
};

/// As typed after --convention and --channels; empty: the contract's.
struct ConventionWords {
    std::string convention, channels;
};

struct RendererChoice {
    std::variant<BuiltIn, Program, StoredFrame> who;
    std::string precision_word;               ///< as typed after --precision; empty: its own promise
    ConventionWords convention{};             ///< of frames that somebody else made
    std::chrono::seconds time_limit{600};     ///< for one picture, of those that run as programs
    std::shared_ptr<KeptInput> kept_input{};  ///< where a program's input is kept; null: nowhere
    std::string ids = "triangle";  ///< what they stand for: a word of scenes/triangle_labels.h, or a file
};

/// Who is compared besides candidate and reference.
struct OracleChoice {
    enum class Need {
        welcome,   ///< where it is absent, the report says so
        named,     ///< somebody asked for it: it is installed, or nothing is begun
        required,  ///< where it is absent, nothing is proven
    };
    enum class Pixels {
        all,
        sample,           ///< as many as a known price buys, where the renderer has samples
        sample_if_cheap,  ///< the same, where that takes less than all else that is done with the scene
    };
    RendererChoice renderer;
    Pixels pixels = Pixels::all;
    Need need = Need::welcome;
};

/// Everybody who has a say in a run.
struct ChosenRenderers {
    RendererChoice candidate{.who = BuiltIn{"zproof"}, .precision_word = {}};
    RendererChoice reference{.who = BuiltIn{"embree"}, .precision_word = {}};
    std::vector<OracleChoice> oracles;  ///< no two of one name, none named like candidate or reference
};

/// A word after --renderer: a name that zproof knows, for vulkan with settings behind it, or a command with
/// {out} in it. Throws UsageError.
RendererChoice renderer_from_word(const std::string& word);

/// What is typed after --ids. Throws UsageError for what is neither a word nor a file.
std::string ids_from_word(const std::string& word);

/// zproof's own rasterizer against Embree, both as they declare themselves? Only of these does the suite's
/// manifest know which classes must occur.
bool are_the_usual(const ChosenRenderers& renderers);

/// The renderer in words: "povray", "vulkan:depth_format=unorm16", the command, the file.
std::string name_of(const RendererChoice& choice);

/// The options that mean this choice, for a shell, each with a blank before it: " --renderer povray". The
/// default is named as well, since a settings file may name another.
std::string options_for(const RendererChoice& choice);

/// With the sample's index in the place of {sample}, in the names of a stored frame's file and channels.
RendererChoice at_sample(RendererChoice choice, const Sample& sample);

/// Does a stored frame's name or do its channels say {sample}? Others are asked for each sample.
bool has_frame_for_each_sample(const RendererChoice& choice);

}  // namespace zproof
