// Functions that GLSL lacks, leaves undefined somewhere, or has only roughly (Mesa's own on the processor: exp2 and log2
// to 1e-5). Relative errors are some 1e-7. Both sides of a choice are harmless to evaluate.

const float kInfinity = uintBitsToFloat(0x7F800000u);
const float kNan = uintBitsToFloat(0x7FC00000u);

/// 2^n for a whole n from -126 to 127.
float powerOfTwo(int n) { return intBitsToFloat((n + 127) << 23); }

/// 2^x = 2^n 2^f with f in [-1/2, 1/2]; (2^f - 1) / f as the polynomial of degree 5 that is best there.
float preciseExp2(float a) {
    float x = clamp(a, -152.0, 130.0);
    float whole = roundEven(x);
    float f = x - whole;
    float p = 0.000154531634;
    p = p * f + 0.00133908633;
    p = p * f + 0.00961808302;
    p = p * f + 0.0555035695;
    p = p * f + 0.240226507;
    p = p * f + 0.693147182;
    float power = p * f + 1.0;
    int n = int(whole);
    int first = n >> 1; // in two parts: each has an exponent that single precision knows
    return power * powerOfTwo(first) * powerOfTwo(n - first);
}

/// log2(x) = e + log2(m) with m = 1 + r in [sqrt(1/2), sqrt(2)); -infinity at 0, no number below.
float preciseLog2(float a) {
    bool tiny = a < 1.17549435e-38;
    float x = tiny ? a * 33554432.0 : a; // 2^25
    int bits = floatBitsToInt(x);
    int e = (bits - 0x3F3504F3) >> 23; // sqrt(1/2)
    float r = intBitsToFloat(bits - (e << 23)) - 1.0;
    float p = -0.110707387;
    p = p * r + 0.183549598;
    p = p * r - 0.189390644;
    p = p * r + 0.204932719;
    p = p * r - 0.239871785;
    p = p * r + 0.288556814;
    p = p * r - 0.360685021;
    p = p * r + 0.480898291;
    p = p * r - 0.721347511;
    float log_ = r * 1.44269504 + r * r * p;
    float sum = float(e) - (tiny ? 25.0 : 0.0) + log_;
    sum = a < kInfinity ? sum : a;
    return a <= 0.0 ? (a < 0.0 ? kNan : -kInfinity) : sum;
}

/// e^x = 2^n e^r with |r| <= ln(2) / 2, whose rest of the reduction is kept.
float preciseExp(float a) {
    float x = clamp(a, -104.0, 89.0);
    float whole = roundEven(x * 1.44269504);
    precise float r = x - whole * 0.693359375; // ln(2) in two parts, the first exact times any whole
    r = r + whole * 2.12194440e-4;
    float p = 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    float power = (p * r + 1.0) * r + 1.0;
    int n = int(whole);
    int first = n >> 1;
    return power * powerOfTwo(first) * powerOfTwo(n - first);
}

/// e^x - 1: near 0 by its series.
float expm1(float x) {
    float s = 1.0 + x / 9.0;
    s = 1.0 + x / 8.0 * s;
    s = 1.0 + x / 7.0 * s;
    s = 1.0 + x / 6.0 * s;
    s = 1.0 + x / 5.0 * s;
    s = 1.0 + x / 4.0 * s;
    s = 1.0 + x / 3.0 * s;
    s = 1.0 + x / 2.0 * s;
    return abs(x) < 0.35 ? x * s : preciseExp(x) - 1.0;
}

/// ln(1 + x); the digits of x that the sum loses are put back (Kahan). -infinity at -1.
float log1p(float x) {
    precise float sum = 1.0 + x;
    precise float kept = sum - 1.0;
    precise float lost = x - kept;
    float safe = sum > 0.0 && x < kInfinity ? sum : 1.0;
    float found = 0.693147181 * preciseLog2(safe) + lost / safe;
    found = x < kInfinity ? found : x;
    return x <= -1.0 ? (x < -1.0 ? kNan : -kInfinity) : found;
}

/// Angle of (x, y) in all four quadrants; 0 at the origin. By the arc tangent of the smaller over the larger.
float preciseAtan2(float y, float x) {
    float larger = max(abs(x), abs(y));
    float t = min(abs(x), abs(y)) / (larger > 0.0 ? larger : 1.0);
    float s = t * t;
    float p = -0.00238699722;
    p = p * s + 0.0135077713;
    p = p * s - 0.0358715393;
    p = p * s + 0.0625016913;
    p = p * s - 0.0865688026;
    p = p * s + 0.110337645;
    p = p * s - 0.142785683;
    p = p * s + 0.199997395;
    p = p * s - 0.333333313;
    float small = t * s * p + t;
    float quarter = abs(y) > abs(x) ? 1.57079637 - small : small;
    float angle = x < 0.0 ? 3.14159274 - quarter : quarter;
    return y < 0.0 ? -angle : angle;
}

float clampedToUnit(float x) { return max(0.0, min(1.0, x)); }

/// x, or the other where x is infinite or no number.
float finiteOr(float x, float other) { return isnan(x) || isinf(x) ? other : x; }

/// x^y with its ends defined: 1 for y = 0, 0 for x <= 0 (numerics.md, powc). What is no number stays none.
float powc(float x, float y) {
    bool nothing = x <= 0.0;
    float power = preciseExp2(y * preciseLog2(nothing ? 1.0 : x));
    return y == 0.0 ? 1.0 : nothing ? 0.0 : isnan(x) ? x : power;
}

/// sign(x) powc(|x|, y)
float spow(float x, float y) {
    float power = powc(abs(x), y);
    return x < 0.0 ? -power : power;
}

/// Hermite step; where the edges are equal it is the step x >= edge, which GLSL leaves open.
float smoothStep(float low, float high, float x) {
    float width = high - low;
    float t = clampedToUnit((x - low) / (width > 0.0 ? width : 1.0));
    return width > 0.0 ? t * t * (3.0 - 2.0 * t) : (x >= low ? 1.0 : 0.0);
}
