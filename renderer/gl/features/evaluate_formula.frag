// One formula for many sets of arguments: set number x + y * kAcross, `argumentCount` numbers each.
uniform samplerBuffer arguments_;
uniform int argumentCount;
uniform int sets;

layout(location = 0) out vec4 result;

void main() {
    int set_ = int(gl_FragCoord.x) + int(gl_FragCoord.y) * kAcross;
    if (set_ >= sets) {
        result = vec4(0.0);
        return;
    }
    int at = set_ * argumentCount;
#define IN(k) texelFetch(arguments_, at + (k)).r
    vec3 found = vec3(0.0);
#if FORMULA == 0
    found.x = opacityOfLength(IN(0), IN(1));
#elif FORMULA == 1
    found.x = contourWidth(IN(0));
#elif FORMULA == 2
    found.x = curvatureOfNormals(vec3(IN(0), IN(1), IN(2)), vec3(IN(3), IN(4), IN(5)), IN(6));
#elif FORMULA == 3
    found.x = contourPush(IN(0), IN(1), IN(2));
#elif FORMULA == 4
    found.x = illustrativeOpacity(IN(0), IN(1), IN(2), IN(3), IN(4));
#elif FORMULA == 5
    found.x = silhouetteness(IN(0), IN(1), vec3(IN(2), IN(3), IN(4)));
#elif FORMULA == 6
    found.x = lightingImportance(IN(0), IN(1), IN(2), ivec3(50, 5, 30)); // the paper's exponents
#elif FORMULA == 7
    found.x = extinctionImportance(IN(0));
#elif FORMULA == 8
    found.x = gaussianLens(IN(0), IN(1), IN(2));
#elif FORMULA == 9
    found.x = boundaryFactor(IN(0), IN(1), vec3(IN(2), IN(3), IN(4)));
#elif FORMULA == 10
    found.x = silhouetteFactor(IN(0), IN(1), vec3(IN(2), IN(3), IN(4)));
#elif FORMULA == 11
    found.x = resolutionFactor(IN(0), IN(1), IN(2), IN(3));
#elif FORMULA == 12
    found.x = distanceFactor(IN(0), IN(1), IN(2));
#elif FORMULA == 13
    found.x = interiorFactor(IN(0), IN(1));
#elif FORMULA == 14
    found.x = lightingFactor(IN(0), IN(1));
#elif FORMULA == 15
    ImportanceRay ray = startOfRay();
    for (int k = 0; k + 2 < argumentCount; k += 3) {
        ray = withSample(ray, IN(k), IN(k + 1), IN(k + 2));
    }
    found = vec3(ray.colour * ray.opacity, ray.opacity, importanceSoFar(ray));
#endif
    result = vec4(found, 1.0);
}
