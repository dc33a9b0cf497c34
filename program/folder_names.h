/// Names of folders and files: safe on any file system, no two alike.
#pragma once

#include <set>
#include <string>

namespace zproof {

/// The text with everything but letters, digits, '-', '_' and '.' turned into '_', not starting with a dot,
/// at most 100 characters.
std::string safe_name(const std::string& text);

class FolderNames {
  public:
    /// "SCENE-VIEW", followed by "-2", "-3", ... where that is taken already (letter case does not count).
    std::string next(const std::string& scene, const std::string& view) { return next(scene + "-" + view); }
    std::string next(const std::string& text);  ///< the same of any text

    void take(const std::string& name);  ///< somebody else has it

  private:
    std::set<std::string> taken_;  ///< in lower case
};

}  // namespace zproof
