#include "core/style/extraction/gather.h"

#include "core/base/task.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limner {
namespace {

/// Votes spread evenly at random over the disk.
template <typename Colour>
std::vector<Vote> votesOver(int count, Colour colour) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-1, 1);
    std::vector<Vote> votes;
    while (static_cast<int>(votes.size()) < count) {
        Vote v;
        v.x = place(random);
        v.y = place(random);
        if (v.x * v.x + v.y * v.y <= 1) {
            v.r = v.g = v.b = colour(v, random);
            v.half = static_cast<std::uint8_t>(random() % 2);
            votes.push_back(v);
        }
    }
    return votes;
}

float slope(const Vote& v) { return 0.5F + 0.3F * v.x - 0.15F * v.y; }

/// RMSE from `truth` where there were votes, within 0.95 of the disk.
template <typename Truth>
double errorOf(const ArtPicture& disk, Truth truth) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < disk.height; ++y) {
        for (int x = 0; x < disk.width; ++x) {
            Vote v;
            v.x = static_cast<float>((2.0 * x + 1) / disk.width - 1);
            v.y = static_cast<float>(1 - (2.0 * y + 1) / disk.height);
            if (disk.at(x, y).a > 0 && std::hypot(v.x, v.y) < 0.95) {
                sum += std::pow(disk.at(x, y).r - truth(v), 2);
                ++count;
            }
        }
    }
    EXPECT_GT(count, 0);
    return std::sqrt(sum / count);
}

Gathered gathered(std::vector<Vote> votes) {
    Task task;
    return gatherVotes(std::move(votes), HeldOut::measured, task);
}

TEST(Gather, APlaneOfColoursComesBackExactly) {
    const Gathered g = gathered(votesOver(40'000, [](const Vote& v, auto&) { return slope(v); }));
    EXPECT_EQ(g.picture.width, 256);
    EXPECT_LT(errorOf(g.picture, slope), 1e-3);
    EXPECT_LT(*g.heldOutRmse, 2e-3);
}

TEST(Gather, NoiseIsAveragedAndReported) {
    const auto noisy = [](const Vote& v, auto& random) {
        return slope(v) + std::normal_distribution<float>(0, 0.05F)(random);
    };
    const Gathered g = gathered(votesOver(100'000, noisy));
    EXPECT_LT(errorOf(g.picture, slope), 0.015);
    EXPECT_NEAR(*g.heldOutRmse, 0.05, 0.005);
}

TEST(Gather, FewOutliersAreLeftOutButReported) {
    const auto blotted = [](const Vote& v, auto& random) {
        return std::uniform_real_distribution<float>(0, 1)(random) < 0.12F ? 0.0F : slope(v);
    };
    const Gathered g = gathered(votesOver(100'000, blotted));
    EXPECT_LT(errorOf(g.picture, slope), 0.01);
    EXPECT_GT(*g.heldOutRmse, 0.1); // a twelfth of the votes off by 0.5: 0.17
}

TEST(Gather, HatchingIsAveragedToItsTone) {
    // Ink on four tenths of the paper: a tone, not outliers.
    const auto hatched = [](const Vote&, auto& random) {
        return std::uniform_real_distribution<float>(0, 1)(random) < 0.4F ? 0.1F : 0.9F;
    };
    const Gathered g = gathered(votesOver(100'000, hatched));
    EXPECT_LT(errorOf(g.picture, [](const Vote&) { return 0.58; }), 0.06);
}

TEST(Gather, PlacesWithoutVotesAreHoles) {
    std::vector<Vote> votes = votesOver(60'000, [](const Vote& v, auto&) { return slope(v); });
    std::erase_if(votes, [](const Vote& v) { return v.x > 0.2F && v.x < 0.5F; });
    const Gathered g = gathered(std::move(votes));
    const int side = g.picture.width;
    const auto at = [&](double x) { return g.picture.at(static_cast<int>((0.5 + 0.5 * x) * side), side / 2).a; };
    EXPECT_EQ(at(0.35), 0);
    EXPECT_EQ(at(0.1), 1);
    EXPECT_EQ(at(0.6), 1);
}

TEST(Gather, FewVotesGiveACoarsePicture) {
    EXPECT_EQ(gatheredSide(100), 32);
    EXPECT_EQ(gatheredSide(2'000'000), 512);
    const Gathered g = gathered(votesOver(300, [](const Vote& v, auto&) { return slope(v); }));
    EXPECT_LT(errorOf(g.picture, slope), 0.02);
}

} // namespace
} // namespace limner
