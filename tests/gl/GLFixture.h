#pragma once
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl/Api.h"
#include "gl/Context.h"

namespace limpid {

/// One context a test program, with debug output on: any message of the driver, and any GL error left behind,
/// fails the test that caused it.
class GLTest : public ::testing::Test {
  protected:
    static gl::Context& context() {
        static gl::Context instance([] {
            gl::ContextOptions options;
            options.debug = true;
            options.onMessage = [](const std::string& message) { messages().push_back(message); };
            return options;
        }());
        return instance;
    }

    void SetUp() override {
        context();
        messages().clear();
    }
    void TearDown() override {
        glFinish(); // lavapipe compiles when it draws: not as the program ends, where LLVM is half gone
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        for (const std::string& message : messages())
            ADD_FAILURE() << message;
    }

    /// For a test that makes the driver complain on purpose: what it said so far.
    static std::vector<std::string>& messages() {
        static std::vector<std::string> all;
        return all;
    }
};

} // namespace limpid
