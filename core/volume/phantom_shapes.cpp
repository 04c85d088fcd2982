#include "core/volume/phantom_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace limner::phantom {

namespace {

// Hounsfield units of the tissues, textbook middles.
constexpr float kAir = -1000, kFat = -95, kSkin = 45, kMuscle = 60, kCsf = 10, kGrey = 40, kWhite = 28, kVitreous = 12,
                kLens = 85, kSpongy = 480, kCortical = 1150, kDentine = 1550, kEnamel = 2600, kContrast = 340,
                kVein = 260, kCartilage = 130;

// ---- distances --------------------------------------------------------------------------------------------------

/// First-order distance to an ellipsoid: the implicit function over the length of its gradient.
float ellipsoid(const Vec& p, const Vec& centre, const Vec& radii) {
    const Vec q = (p - centre) / radii;
    const float k0 = glm::length(q);
    const float k1 = glm::length(q / radii);
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -std::min({radii.x, radii.y, radii.z});
}

/// A capsule whose radius runs from `ra` at a to `rb` at b.
float capsule(const Vec& p, const Vec& a, const Vec& b, glm::vec2 radii) {
    const Vec ab = b - a;
    const float t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0F, 1.0F);
    return glm::length(p - a - t * ab) - glm::mix(radii.x, radii.y, t);
}

/// Union with a fillet of about `k` mm.
float blend(float a, float b, float k) {
    const float h = std::max(k - std::abs(a - b), 0.0F) / k;
    return std::min(a, b) - 0.25F * k * h * h;
}

float carve(float solid, float hole, float k) { return -blend(-solid, hole, k); }

/// The right half stands for both: the head is symmetric unless a shape says otherwise.
Vec folded(const Vec& p) { return {std::abs(p.x), p.y, p.z}; }

// ---- surfaces ---------------------------------------------------------------------------------------------------

float ear(const Vec& p) {
    // Local frame: the pinna leans back by some 15 degrees and stands off the head by some 25.
    const Vec d = p - Vec(79, 16, -2);
    const float y = 0.966F * d.y + 0.259F * d.z;
    const float z = 0.966F * d.z - 0.259F * d.y;
    const float x = 0.906F * d.x - 0.423F * y;
    const float along = 0.906F * y + 0.423F * d.x;
    const Vec q(x, along, z);
    // Helix: a ring of elliptic course; lobe below; concha as a shallow bowl.
    const float ring = glm::length(glm::vec2(q.y / 14.0F, q.z / 24.0F));
    const float helix = glm::length(glm::vec2((ring - 1) * 17.0F, q.x - 1.5F)) - 3.1F;
    const float plate = ellipsoid(q, {-1.5F, 0, -1}, {3.0F, 14, 24});
    const float antihelix =
        glm::length(glm::vec2((glm::length(glm::vec2((q.y - 1) / 8.0F, (q.z - 2) / 15.0F)) - 1) * 10.0F, q.x - 0.5F)) -
        2.0F;
    const float lobe = ellipsoid(q, {0.5F, -4, -25}, {3.5F, 7.5F, 9});
    return blend(blend(blend(helix, plate, 2.5F), antihelix, 2), lobe, 6);
}

float nose(const Vec& p) {
    float d = capsule(p, {0, -88, 14}, {0, -107, -21}, {6.5F, 8.5F});
    d = blend(d, ellipsoid(p, {0, -106, -24}, {9.5F, 9.5F, 8.5F}), 5);
    d = blend(d, ellipsoid(folded(p), {11.5F, -98, -28}, {6.5F, 9.5F, 7}), 5);
    return carve(d, ellipsoid(folded(p), {5.8F, -101, -36}, {3.3F, 6.5F, 5.5F}), 2.5F);
}

float mouth(const Vec& p) {
    const float bow = 1.6F * std::exp(-p.x * p.x / 14.0F); // the dip under the nose
    const float upper = ellipsoid(p + Vec(0, 0, bow), {0, -92.5F, -50.5F}, {23, 8, 4.2F});
    const float lower = ellipsoid(p, {0, -91.5F, -58.8F}, {20, 8, 5});
    return blend(upper, lower, 0.8F);
}

/// The outer surface of the skin.
float skin(const Vec& p) {
    const Vec f = folded(p);
    float d = ellipsoid(p, {0, 10, 32}, {76, 94, 79});
    d = blend(d, ellipsoid(p, {0, -28, -30}, {60, 60, 72}), 30);
    d = blend(d, ellipsoid(f, {34, -50, -52}, {28, 34, 40}), 25);        // cheeks and jaw
    d = blend(d, ellipsoid(p, {0, -74, -84}, {25, 20, 19}), 22);         // chin
    d = blend(d, capsule(p, {0, 26, -40}, {0, 40, -150}, {52, 58}), 30); // neck
    d = blend(d, ellipsoid(f, {22, -78, 21}, {24, 11, 7.5F}), 12);       // brows
    d = blend(d, ellipsoid(f, {44, -62, -14}, {15, 15, 12}), 16);        // cheek bones
    d = carve(d, ellipsoid(f, {30, -97, 4}, {18, 17, 12}), 14);          // eye sockets
    d = blend(d, ellipsoid(f, {30, -75, 5}, {14.5F, 14, 13}), 3);        // lids over the eyes
    d = carve(d, ellipsoid(f, {31, -90, 3.5F}, {12, 4, 0.7F}), 1.2F);    // slit between the lids
    d = blend(d, nose(p), 7);
    d = blend(d, mouth(p), 5);
    d = carve(d, ellipsoid(p, {0, -99, -54.6F}, {22, 9, 0.6F}), 1.6F); // slit between the lips
    d = carve(d, ellipsoid(p, {0, -97.5F, -68}, {15, 5, 4}), 7);       // fold over the chin
    d = blend(d, ear(f), 6);
    return carve(d, capsule(f, {84, 10, -4}, {66, 8, -3}, {4, 3}), 2); // ear canal
}

float orbit(const Vec& p) {
    const Vec f = folded(p);
    const float mouthOfOrbit = ellipsoid(f, {31, -84, 6}, {19.5F, 22, 17});
    return blend(mouthOfOrbit, capsule(f, {29, -70, 6}, {13, -38, 3}, {14, 4}), 8);
}

float nasalAperture(const Vec& p) {
    const float pear = ellipsoid(p, {0, -84, -21}, {12.5F, 22, 13});
    return blend(blend(pear, ellipsoid(p, {0, -88, -7}, {6, 16, 13}), 8), ellipsoid(p, {0, -52, -14}, {14, 40, 17}),
                 10);
}

float zygoma(const Vec& f) {
    float d = ellipsoid(f, {42, -60, -16}, {13, 10, 8});
    d = blend(d, capsule(f, {46, -60, -8}, {50, -58, 22}, {5, 6}), 8); // lateral rim of the orbit
    d = blend(d, capsule(f, {48, -56, -15}, {68, -28, -14}, {5, 3.8F}), 6);
    return blend(d, capsule(f, {68, -28, -14}, {68, 4, -12}, {3.8F, 4.5F}), 5);
}

float mandible(const Vec& p) {
    const Vec f = folded(p);
    // The body is a band, taller than thick: measured in a frame that squeezes z.
    const Vec squeeze(1, 1, 0.5F);
    const Vec q = f * squeeze;
    float d = capsule(q, Vec(0, -76, -82) * squeeze, Vec(17, -72, -82) * squeeze, {6, 5.5F});
    d = blend(d, capsule(q, Vec(17, -72, -82) * squeeze, Vec(38, -38, -76) * squeeze, {5.5F, 5.5F}), 5);
    d = blend(d, capsule(q, Vec(38, -38, -76) * squeeze, Vec(49, -10, -68) * squeeze, {5.5F, 5}), 5);
    d = blend(d, ellipsoid(p, {0, -79, -90}, {14, 7, 8}), 8);
    // The ramus is a plate, thin across.
    const Vec flat(2.2F, 1, 1);
    const Vec r = f * flat;
    float ramus = capsule(r, Vec(49, -12, -64) * flat, Vec(53, -6, -30) * flat, {13, 12});
    ramus = blend(ramus, capsule(r, Vec(53, 0, -30) * flat, Vec(53, 3, -16) * flat, {9, 8}), 6);     // condyle
    ramus = blend(ramus, capsule(r, Vec(53, -16, -34) * flat, Vec(52, -20, -18) * flat, {7, 4}), 5); // coronoid process
    return blend(d, ramus / 2.2F, 5);
}

/// The dental arch: distance in the plane to its middle line (an ellipse open to the back).
float arch(const Vec& p, glm::vec2 radii) {
    const glm::vec2 q = glm::vec2(p.x, p.y + 48) / radii;
    const float k = glm::length(q);
    const float slope = glm::length(q / radii);
    const float side = slope > 0 ? std::abs(k * (k - 1) / slope) : radii.x;
    return p.y > -42 ? glm::length(glm::vec2(side, p.y + 42)) : side;
}

float alveolar(const Vec& p, float z, glm::vec2 radii) {
    const float d = arch(p, radii);
    return glm::length(glm::vec2(d / 5.5F, (p.z - z) / 8.0F)) * 5.5F - 5.5F;
}

float maxilla(const Vec& p) {
    const Vec f = folded(p);
    float d = ellipsoid(p, {0, -50, -22}, {37, 32, 22});
    d = blend(d, alveolar(p, -40, {27, 36}), 8);
    d = blend(d, capsule(f, {9, -84, 14}, {14, -80, -16}, {4, 5}), 6); // frontal process beside the nose
    d = blend(d, capsule(p, {0, -82, -35}, {0, -88, -36}, {3, 2}), 4); // nasal spine
    return d;
}

float cranium(const Vec& p) { return ellipsoid(p, {0, 10, 31}, {69.5F, 87.5F, 72.5F}); }

/// All bone of the head but the jaw and the neck.
float skull(const Vec& p) {
    const Vec f = folded(p);
    float d = cranium(p);
    d = blend(d, ellipsoid(f, {24, -66, 24}, {26, 13, 8}), 8); // brow ridges
    d = blend(d, maxilla(p), 8);
    d = blend(d, zygoma(f), 6);
    d = blend(d, ellipsoid(f, {54, 24, -24}, {10, 14, 18}), 12);     // mastoids
    d = blend(d, capsule(p, {0, -82, 17}, {0, -93, -3}, {6, 4}), 6); // nasal bones
    d = carve(d, ellipsoid(f, {68, -34, 4}, {10, 26, 24}), 14);      // temporal fossae
    d = carve(d, orbit(p), 3);
    return carve(d, nasalAperture(p), 2);
}

/// The cranial cavity; the bone left around it is some 6.5 mm thick.
float cavity(const Vec& p) { return std::max(ellipsoid(p, {0, 10, 31}, {63, 81, 66}), skull(p) + 3.0F); }

/// Folds of the cortex: a smooth, fixed pattern of ridges some 12 mm apart.
float folds(const Vec& p) {
    const Vec q = p * 0.26F;
    const float warp = 1.5F * std::sin(0.9F * q.y + 1.3F * std::sin(0.6F * q.z)) + std::sin(1.1F * q.x + q.z);
    const float ridge = std::sin(q.z + warp) + std::sin(1.2F * q.y + 0.7F * warp + std::abs(q.x));
    return 1.5F - 0.9F * std::abs(ridge);
}

float brain(const Vec& p) {
    float d = ellipsoid(p, {0, 8, 34}, {60.5F, 78, 59.5F});
    d = blend(d, ellipsoid(folded(p), {30, 0, 4}, {26, 38, 20}), 12); // temporal lobes
    d += std::max(0.0F, folds(p)) * 2.2F;
    d = carve(d, std::max(std::abs(p.x) - 0.9F, 18 - p.z), 2); // longitudinal fissure
    const float cerebellum =
        ellipsoid(folded(p), {22, 50, -12}, {26, 26, 19}) + 0.8F * std::sin(0.9F * p.z + 0.2F * p.y);
    const float stem = capsule(p, {0, 14, 0}, {0, 30, -45}, {13, 8});
    return std::max(std::min({d, cerebellum, stem}), cavity(p) + 1.8F);
}

// ---- the painting -----------------------------------------------------------------------------------------------

class Canvas {
  public:
    void add(std::vector<Layer> layers, std::pair<Vec, Vec> box, std::function<float(const Vec&)> distance) {
        paints_.push_back(
            {0.5F * (box.first + box.second), 0.5F * (box.second - box.first), std::move(layers), std::move(distance)});
    }
    void add(float hu, std::pair<Vec, Vec> box, std::function<float(const Vec&)> distance) {
        add(std::vector<Layer>{{0, hu}}, std::move(box), std::move(distance));
    }
    void addEllipsoid(float hu, const Vec& centre, const Vec& radii) {
        add(hu, {centre - radii, centre + radii}, [=](const Vec& p) { return ellipsoid(p, centre, radii); });
    }
    /// A tube through points with a radius that runs evenly from first to last.
    void addTube(float hu, const std::vector<Vec>& points, glm::vec2 radii) {
        const auto last = static_cast<float>(points.size() - 1);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec a = points[i];
            const Vec b = points[i + 1];
            const glm::vec2 r(glm::mix(radii.x, radii.y, static_cast<float>(i) / last),
                              glm::mix(radii.x, radii.y, static_cast<float>(i + 1) / last));
            const float widest = std::max(r.x, r.y);
            add(hu, {glm::min(a, b) - widest, glm::max(a, b) + widest},
                [=](const Vec& p) { return capsule(p, a, b, r); });
        }
    }
    [[nodiscard]] std::vector<Paint> take() { return std::move(paints_); }

  private:
    std::vector<Paint> paints_;
};

const std::pair<Vec, Vec> kWholeHead = {{-100, -122, -150}, {100, 110, 115}};

void paintSoftTissue(Canvas& canvas) {
    canvas.add({{0, kSkin}, {2.2F, kFat}, {5.0F, kMuscle}}, kWholeHead, skin);
    canvas.addEllipsoid(kCartilage, {79, 16, -2}, {1.5F, 9, 16});
}

void paintNeckBones(Canvas& canvas) {
    for (int i = 0; i < 7; ++i) {
        const auto k = static_cast<float>(i);
        const Vec c(0, 33 + 1.2F * k, -50 - 17 * k);
        const auto vertebra = [c](const Vec& p) {
            float d = ellipsoid(p, c, {12.5F, 9.5F, 7.8F});
            d = blend(d, capsule(folded(p), c + Vec(10, 6, 0), c + Vec(22, 5, -2), {4.5F, 3.5F}), 4);
            d = blend(d, capsule(folded(p), c + Vec(13, 9, 0), c + Vec(4, 24, -2), {4.0F, 4.0F}), 4);
            d = blend(d, capsule(p, c + Vec(0, 25, -2), c + Vec(0, 40, -7), {4.0F, 3.0F}), 4);
            return carve(d, capsule(p, c + Vec(0, 16, -20), c + Vec(0, 16, 20), {7.5F, 7.5F}), 2);
        };
        const std::pair<Vec, Vec> box = {c - Vec(27, 12, 13), c + Vec(27, 45, 11)};
        canvas.add({{0, kCortical - 250}, {2.2F, kSpongy - 180}}, box, vertebra);
    }
}

void paintBones(Canvas& canvas) {
    const std::pair<Vec, Vec> skullBox = {{-76, -98, -60}, {76, 100, 106}};
    canvas.add({{0, kCortical}, {2.2F, kSpongy}}, skullBox, skull);
    canvas.add({{-2.0F, kCortical}, {0, kCsf}}, skullBox, cavity);
    const std::pair<Vec, Vec> jawBox = {{-62, -92, -102}, {62, 16, -4}};
    canvas.add({{0, kCortical}, {2.4F, kSpongy}}, jawBox, mandible);
    const auto lowerRidge = [](const Vec& p) { return alveolar(p, -70, {25.5F, 33.5F}); };
    canvas.add(kCortical - 200, {{-34, -88, -80}, {34, -34, -60}}, lowerRidge);
    paintNeckBones(canvas);
}

void paintTeeth(Canvas& canvas) {
    constexpr int kPerSide = 7;
    for (const bool upper : {true, false}) {
        const glm::vec2 radii = upper ? glm::vec2(27, 37.5F) : glm::vec2(25.5F, 35);
        float angle = upper ? 8.0F : 6.5F; // degrees from the middle of the arch
        for (int i = 0; i < kPerSide; ++i) {
            const float turn = glm::radians(angle);
            const Vec at(radii.x * std::sin(turn), -48 - radii.y * std::cos(turn), upper ? -50.5F : -61.5F);
            const bool molar = i >= 4;
            const float across = molar ? 4.6F : (upper && i == 0 ? 4.2F : 3.3F);
            const Vec crown(across, molar ? 4.6F : 3.2F, molar ? 4.8F : 5.8F);
            const float toRoot = upper ? 1.0F : -1.0F;
            canvas.addEllipsoid(kDentine, at + Vec(0, 0, 9 * toRoot), {crown.x * 0.72F, crown.y * 0.72F, 9});
            canvas.addEllipsoid(kEnamel, at, crown);
            angle += molar ? 14.0F : (upper ? 12.5F : 11.0F);
        }
    }
}

void paintAirways(Canvas& canvas) {
    canvas.add(kAir, {{-15, -96, -36}, {15, -8, 6}}, [](const Vec& p) {
        const float wall = std::abs(p.x) - 1.2F;                                      // septum
        const float turbinates = 2.2F * std::sin(0.55F * p.z + 0.4F * std::abs(p.x)); // folds of the side wall
        return std::max({nasalAperture(p) + 4.5F + turbinates, -wall, skin(p) + 4.5F});
    });
    canvas.addEllipsoid(kAir, {25, -52, -20}, {10, 15, 12}); // maxillary sinuses
    canvas.addEllipsoid(kAir, {12, -71, 28}, {8, 3.0F, 5});  // frontal sinuses
    canvas.addEllipsoid(kAir, {0, -22, -4}, {10, 10, 8});    // sphenoid sinus
    canvas.addTube(kAir, {{5.8F, -101, -38}, {5.5F, -92, -30}, {4, -82, -26}}, {3.0F, 4.0F});
    canvas.addTube(kAir, {{0, -12, -20}, {0, -2, -52}, {0, 4, -90}, {0, 2, -150}}, {8, 8.5F});
    canvas.addTube(kAir, {{84, 10, -4}, {58, 9, -2}}, {3.4F, 2.6F});
}

void paintHeadContents(Canvas& canvas) {
    const std::pair<Vec, Vec> inside = {{-66, -74, -38}, {66, 94, 100}};
    canvas.add({{0, kGrey}, {4.0F, kWhite}}, inside, brain);
    canvas.addTube(kCsf, {{0, 22, -10}, {0, 45, -36}, {0, 50, -60}, {0, 58, -150}}, {9, 6.5F});
    canvas.addTube(kWhite, {{0, 20, -8}, {0, 45, -36}, {0, 50, -60}, {0, 58, -150}}, {7, 4.5F});
    canvas.addTube(kCsf, {{6, -20, 36}, {9, 0, 44}, {12, 24, 42}, {20, 40, 30}, {26, 22, 14}}, {5, 3.5F});
    const std::pair<Vec, Vec> orbits = {{-52, -92, -14}, {52, -34, 26}};
    canvas.add(kFat + 10, orbits, [](const Vec& p) { return std::max(orbit(p) + 0.5F, skin(p) + 3.0F); });
    canvas.addTube(kMuscle, {{30, -66, 5}, {15, -38, 3}}, {2.2F, 2.0F}); // optic nerve
    canvas.addEllipsoid(kMuscle, {30, -75.5F, 5}, Vec(12.6F));
    canvas.addEllipsoid(kVitreous, {30, -75.5F, 5}, Vec(11.4F));
    canvas.addEllipsoid(kLens, {30, -84, 5}, {4.8F, 2.4F, 4.8F});
}

void paintVessels(Canvas& canvas) {
    canvas.addTube(kContrast,
                   {{26, 8, -150},
                    {28, 4, -96},
                    {27, 2, -70},
                    {25, 8, -46},
                    {20, 6, -30},
                    {13, -2, -20},
                    {12, -12, -14},
                    {11, -8, -6},
                    {12, -2, 0}},
                   {3.6F, 2.4F});
    canvas.addTube(kContrast, {{27, 2, -72}, {36, -14, -60}, {50, -10, -34}, {62, -4, -10}, {70, -4, 14}},
                   {2.6F, 1.5F});
    canvas.addTube(kContrast, {{12, -2, 0}, {28, -6, 4}, {44, -6, 12}, {52, 6, 26}, {55, 22, 40}, {50, 42, 52}},
                   {2.3F, 1.3F});
    canvas.addTube(kContrast, {{44, -6, 12}, {50, -20, 30}, {46, -24, 50}, {40, -16, 68}}, {1.8F, 1.2F});
    canvas.addTube(kContrast, {{52, 6, 26}, {56, 26, 22}, {52, 46, 24}, {42, 62, 34}}, {1.7F, 1.1F});
    canvas.addTube(
        kContrast,
        {{12, -2, 0}, {4, -18, 2}, {2.6F, -38, 16}, {2.6F, -40, 40}, {2.6F, -18, 62}, {2.6F, 14, 72}, {2.6F, 44, 66}},
        {2.0F, 1.2F});
    canvas.addTube(kContrast, {{14, 34, -150}, {14, 34, -60}, {16, 34, -42}, {7, 24, -32}, {0, 10, -22}}, {2.4F, 2.0F});
    canvas.addTube(kContrast, {{0, 10, -22}, {0, 2, -8}, {0, 2, 0}}, {2.2F, 2.2F});
    canvas.addTube(kContrast, {{0, 2, 0}, {14, 10, 2}, {22, 28, 6}, {16, 54, 12}, {10, 72, 22}}, {1.9F, 1.2F});
    canvas.addTube(kVein, {{34, 12, -150}, {34, 14, -70}, {30, 20, -36}, {38, 42, -22}, {42, 66, -6}, {0, 88, 8}},
                   {4.6F, 3.2F});
    canvas.addTube(kVein, {{0, 88, 8}, {0, 88, 42}, {0, 72, 74}, {0, 44, 91}, {0, 10, 96}, {0, -24, 89}, {0, -50, 70}},
                   {3.2F, 1.4F});
}

} // namespace

std::vector<Paint> headPaints() {
    Canvas canvas;
    paintSoftTissue(canvas);
    paintBones(canvas);
    paintTeeth(canvas);
    paintAirways(canvas);
    paintHeadContents(canvas);
    paintVessels(canvas);
    return canvas.take();
}

} // namespace limner::phantom
