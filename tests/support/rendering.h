#pragma once

#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/backend.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace limner::testing {

std::shared_ptr<const RenderPlan> planOf(const Figure& figure, const PlanRequest& request);
std::shared_ptr<const RenderPlan> planOf(const accuracy::AnalyticScene& scene);

/// The whole picture of a plan.
Picture renderWhole(const Backend& backend, const RenderPlan& plan);
Picture renderWhole(const Backend& backend, const accuracy::AnalyticScene& scene);

/// The same, put together from tiles: so many across and down.
Picture renderTiles(const Backend& backend, const RenderPlan& plan, glm::ivec2 tiles);

/// Root of the mean square over pixels and channels.
double rootMeanSquare(const Picture& a, const Picture& b);
double largestDifference(const Picture& a, const Picture& b);
bool sameBits(const Picture& a, const Picture& b);

/// Pixels that are not finite or whose alpha leaves [0, 1].
int unsoundPixels(const Picture& picture);

/// Order of convergence between errors at steps h and h / 2.
double observedOrder(double errorCoarse, double errorFine);

/// Tests that every backend has to pass; the parameter is the backend's name.
class BackendTest : public ::testing::TestWithParam<std::string> {
  protected:
    BackendTest();
    void SetUp() override {
        if (backend_ == nullptr) {
            GTEST_SKIP() << "no OpenGL here";
        }
    }
    [[nodiscard]] const Backend& backend() const { return *backend_; }
    [[nodiscard]] bool isReference() const { return GetParam() == "reference"; }
    /// Rounding that this backend adds to a pixel: `inDouble` for the reference, `inSingle` otherwise.
    [[nodiscard]] double rounding(double inDouble, double inSingle) const {
        return isReference() ? inDouble : inSingle;
    }

  private:
    std::shared_ptr<const Backend> backend_; ///< null: this machine has it not
};

std::string backendName(const ::testing::TestParamInfo<std::string>& info);

/// Runs a BackendTest suite on every backend.
#define LIMNER_ON_EVERY_BACKEND(suite)                                                                                 \
    INSTANTIATE_TEST_SUITE_P(On, suite, ::testing::Values("reference", "cpu", "gl"), ::limner::testing::backendName)

} // namespace limner::testing
