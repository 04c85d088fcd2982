float opacityOfLength(float opacity, float ratio) { return opacity >= 1.0 - 1e-7 ? 1.0 : -expm1(ratio * log1p(-opacity)); }
float opticalDepth(float opacity) { return opacity >= 1.0 ? 1e30 : -log1p(-max(opacity, 0.0)); }
float contourWidth(float tk) { float t = clampedToUnit(tk); return sqrt(t * (2.0 - t)); }
float contourPush(float radius, float facing, float width) { float f = clampedToUnit(facing), r = clampedToUnit(radius); return f < width ? (r * width >= f ? 1.0 : min(1.0, r * width / (f > 0.0 ? f : 1.0))) : r; }
float contourCoverage(float facing, float width) { return width > 0.0 ? 1.0 - smoothStep(0.9 * width, width, facing) : 0.0; }
float curvatureOfNormals(vec3 a, vec3 b, float d) { return d > 0.0 ? atan(length(cross(a, b)), dot(a, b)) / d : 0.0; }
float curvatureAlongView(float second, float tangentSquared, float g) { float s = tangentSquared * g; return s > 0.0 ? abs(second) / s : 0.0; }
float illustrativeOpacity(float directional, float opacity, float facing, float width, float g) { float over = max(0.0, clampedToUnit(facing) - width); float e = 0.5 + over * (1.0 - clampedToUnit(g)); return directional * (opacity > 0.0 ? powc(min(1.0, opacity), e) : 0.0); }
float mipLevel(float radius, float footprint, float curvature) { float t = radius * footprint * max(1.0 / 32.0, abs(curvature)); return clampedToUnit(footprint - 1.0) * log2(max(1.0, t)); }
float intensityImportance(float v) { return clampedToUnit(v); }
float extinctionImportance(float e) { return log1p(min(1e6, max(0.0, e))); }
float silhouetteness(float g, float f, vec3 terms) { return powc(clampedToUnit(g), terms.x) * smoothStep(terms.y, terms.z, 1.0 - clampedToUnit(f)); }
float unocclusionImportance(float depth) { return max(0.0, 20.0 - depth); }
vec3 halfwayDirection(vec3 l, vec3 v) { vec3 h = l + v; float m = length(h); return m > 0.0 ? h / m : vec3(0.0); }
float wholePower(float x, int n) { float r = 1.0; float s = x; for (int b = n; b != 0; b >>= 1) { if ((b & 1) != 0) r *= s; s *= s; } return r; }
float lightingImportance(float h, float l, float g, ivec3 e) { return 3.0 - wholePower(clampedToUnit(h), e.x) - wholePower(clampedToUnit(l), e.y) - wholePower(1.0 - clampedToUnit(g), e.z); }
float totalImportance(float w, float s) { return max(0.0, min(64.0, w * s)); }
float importanceOfVisible(float i, float e, float floor_) { return i * smoothStep(floor_, 4.0 * floor_, e); }
float keptBehind(inout float opacity, inout float exponential, float a, float x) { float share = exponential + a * max(0.0, x - exponential); float whole = opacity + (1.0 - opacity) * a; bool claims = opacity * x > exponential; float kept = (claims ? exponential : opacity) / (claims ? share : whole); opacity = whole; exponential = share; return kept; }
float tonePlace(float n, float d) { return 0.5 + 0.5 * d * clamp(n, -1.0, 1.0); }
float silhouetteShare(float f, float full, float none, float d) { return d * (1.0 - smoothStep(full, none, abs(f))); }
float halfway(float n, float f, float l) { float s = 2.0 + 2.0 * l; return s > 1e-6 ? clampedToUnit((n + f) / sqrt(s)) : 0.0; }
float withLine(float s, float l) { return s + l - s * l; }
float lineShare(float s, float l) { float a = withLine(s, l); return a > 0.0 ? l / a : 0.0; }
float keptByPlane(float inside, float reach) { return reach > 1e-6 ? clampedToUnit(0.5 + inside / reach) : inside >= 0.0 ? 1.0 : 0.0; }
float cutFaceShare(float v) { return clampedToUnit(2.0 - v); }
float slopeOfCopy(float s) { float b = max(0.0, abs(s) - 1.0); return s < 0.0 ? -b : b; }
float blurLevel(float depth, float focus, float strength) { return min(3.0, 4.0 * strength * abs(depth - focus)); }
float ambientOcclusion(float mean, float along, float d) { return d * clampedToUnit(mean + 2.0 * along); }
float shadowed(float o, float n, float d) { return d * clampedToUnit(o) * smoothStep(0.0, 0.3, n); }
vec3 projectionWeights(vec3 n) { vec3 f = n * n * n * n; float s = f.x + f.y + f.z; return s > 0.0 ? f / s : vec3(0.0); }
