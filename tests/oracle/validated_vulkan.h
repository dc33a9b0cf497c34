/// Vulkan under Khronos' validation layer: its messages fail tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/support/test_folder.h"

namespace zproof::oracle {

/// Turns the layer on for all instances that this process makes: errors, warnings, advice on performance, and
/// hazards between commands. It prints what it finds.
inline void turn_validation_on() {
    static const TestFolder folder;
    folder.write(
        "vk_layer_settings.txt",
        "khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG\n"
        "khronos_validation.report_flags = error,warn,perf\n"
        "khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT\n");
    setenv("VK_LAYER_SETTINGS_PATH", folder.path().c_str(), 1);
    setenv("VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation", 1);
}

/// A test in which the layer must say nothing.
class ValidatedVulkan : public testing::Test {
  protected:
    static void SetUpTestSuite() { turn_validation_on(); }
    void SetUp() override { testing::internal::CaptureStdout(); }
    void TearDown() override {
        const std::string said = testing::internal::GetCapturedStdout();
        if (!said.empty()) ADD_FAILURE() << said;
    }
};

}  // namespace zproof::oracle
