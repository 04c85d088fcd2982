float preciseExp(float x) { return exp(x); }
float log1p(float x) { return abs(x) < 0.05 ? x * (1.0 - x * (0.5 - x * (1.0/3.0 - x * (0.25 - x * (0.2 - x / 6.0))))) : log(1.0 + x); }
float expm1(float x) { return abs(x) < 0.05 ? x * (1.0 + x * (0.5 + x * (1.0/6.0 + x * (1.0/24.0 + x / 120.0)))) : exp(x) - 1.0; }
float powc(float x, float y) { return y == 0.0 ? 1.0 : x <= 0.0 ? 0.0 : exp2(y * log2(x)); }
float clampedToUnit(float x) { return max(0.0, min(1.0, x)); }
float smoothStep(float low, float high, float x) { float w = high - low; float t = clampedToUnit((x - low) / (w > 0.0 ? w : 1.0)); return w > 0.0 ? t * t * (3.0 - 2.0 * t) : x >= low ? 1.0 : 0.0; }
