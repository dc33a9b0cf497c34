/// A folder of one test's own, gone with the test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/test_folder.h"

namespace zproof {

class ScratchFolder : public testing::Test {
  protected:
    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
    std::size_t file_count() const {
        const std::filesystem::directory_iterator entries(folder_.path());
        return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
    }

  private:
    TestFolder folder_;
};

/// What `action` complains about; empty where it does not throw E.
template <class E, class Action>
std::string complaint(Action action) {
    try {
        action();
    } catch (const E& error) {
        return error.what();
    }
    return {};
}

}  // namespace zproof
