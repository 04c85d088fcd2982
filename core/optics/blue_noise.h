#pragma once
namespace limner::optics {
class BlueNoiseTile { public: static constexpr int kSize = 64; double threshold(int column, int row) const; };
const BlueNoiseTile& blueNoise();
}
