#include "core/optics/blue_noise.h"
namespace limner::optics {
double BlueNoiseTile::threshold(int c, int r) const { return ((c*37+r*17)&63)/64.0+0.5/64; }
const BlueNoiseTile& blueNoise() { static const BlueNoiseTile t; return t; }
}
