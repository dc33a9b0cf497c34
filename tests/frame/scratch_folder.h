/// A folder of one test's own, gone with the test.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace zproof {

class ScratchFolder : public testing::Test {
  protected:
    ScratchFolder() { std::filesystem::create_directories(folder_); }
    ~ScratchFolder() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(const std::string& name) const { return folder_ / name; }
    std::size_t file_count() const {
        const std::filesystem::directory_iterator entries(folder_);
        return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
    }

  private:
    static std::string unique_name() {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        return std::string("zproof_") + test->test_suite_name() + "_" + test->name() + "_" +
               std::to_string(getpid());
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / unique_name();
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
