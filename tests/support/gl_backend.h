#pragma once

#include "core/base/error.h"
#include "renderer/gl/gl_backend.h"

#include <gtest/gtest.h>

#include <iostream>
#include <memory>

namespace limner::testing {

/// The OpenGL backend that tests draw with, one for a program: Mesa on the processor, else whatever EGL gives. Null,
/// and a line that says why, where no context opens.
inline GlBackend* sharedGl() {
    static const std::unique_ptr<GlBackend> backend = [] {
        for (const char* library : {"osmesa", "egl"}) {
            try {
                return makeGlBackend(gl::contextFactory(library));
            } catch (const Error& error) {
                std::cout << library << ": " << error.what() << '\n';
            }
        }
        return std::unique_ptr<GlBackend>();
    }();
    return backend.get();
}

/// Skips where there is no OpenGL; no test leaves a complaint of the driver behind.
class GlTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (sharedGl() == nullptr) {
            GTEST_SKIP() << "no OpenGL here";
        }
        complaints_ = sharedGl()->complaints().size();
    }
    void TearDown() override {
        if (sharedGl() != nullptr) {
            const auto all = sharedGl()->complaints();
            EXPECT_EQ(all.size(), complaints_) << all.back();
        }
    }
    [[nodiscard]] static GlBackend& gl() { return *sharedGl(); }

  private:
    std::size_t complaints_ = 0;
};

} // namespace limner::testing
