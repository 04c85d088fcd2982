#include "core/figure/variants.h"

#include "core/figure/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limner {
namespace {

Figure figureWithContours() {
    Figure figure;
    Layer bone;
    bone.name = "Bone";
    bone.contours = Contours{};
    bone.transfer.opacity = {{0, 0}, {1, 1}};
    figure.layers = {Layer{}, bone};
    return figure;
}

const VariedSetting* find(const std::vector<VariedSetting>& settings, const std::string& pointer) {
    const auto found = std::ranges::find(settings, pointer, &VariedSetting::pointer);
    return found == settings.end() ? nullptr : &*found;
}

TEST(Variants, OnlyWhatTheFigureHasIsOffered) {
    const std::vector<VariedSetting> settings = variedSettings(figureWithContours());
    const VariedSetting* thickness = find(settings, "/layers/1/contours/thickness_mm");
    ASSERT_NE(thickness, nullptr);
    EXPECT_EQ(thickness->now, 0.8);
    EXPECT_EQ(thickness->unit, "mm on paper");
    EXPECT_TRUE(thickness->label.starts_with("Bone: "));
    EXPECT_EQ(find(settings, "/layers/0/contours/thickness_mm"), nullptr) << "that layer has none";
    EXPECT_EQ(find(settings, "/importance/global"), nullptr);
    for (const VariedSetting& setting : settings) {
        EXPECT_FALSE(setting.pointer.starts_with("/camera")) << setting.pointer;
        const Parameter* parameter = findParameter(setting.pointer);
        ASSERT_NE(parameter, nullptr);
        EXPECT_GE(setting.from, *parameter->low) << setting.pointer;
        EXPECT_LE(setting.to, *parameter->high) << setting.pointer;
    }
    Figure weighed = figureWithContours();
    weighed.importance = Importance{};
    EXPECT_NE(find(variedSettings(weighed), "/importance/global"), nullptr);
}

TEST(Variants, EvenStepsFromEndToEnd) {
    const Figure figure = figureWithContours();
    VariedSetting setting = *find(variedSettings(figure), "/layers/1/contours/thickness_mm");
    setting.from = 0.5;
    setting.to = 2;
    const std::vector<Variant> variants = variantsOf(figure, setting, 4);
    ASSERT_EQ(variants.size(), 4U);
    const double expected[] = {0.5, 1, 1.5, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_DOUBLE_EQ(variants[i].figure.layers[1].contours->thicknessMm, expected[i]);
        Figure back = variants[i].figure;
        back.layers[1].contours->thicknessMm = 0.8;
        EXPECT_EQ(back, figure) << "nothing else differs";
    }
    EXPECT_EQ(variants[1].name, "1 mm on paper");
}

TEST(Variants, EveryOfferedSettingCanBeSet) {
    Figure figure = figureWithContours();
    figure.importance = Importance{};
    figure.stipple = Stipple{};
    figure.depthCues = DepthCues{};
    for (const VariedSetting& setting : variedSettings(figure))
        EXPECT_NO_THROW(variantsOf(figure, setting, 3)) << setting.pointer;
}

} // namespace
} // namespace limner
