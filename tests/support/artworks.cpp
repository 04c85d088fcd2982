#include "support/artworks.h"

#include <OpenImageIO/imageio.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <opencv2/imgproc.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace limner::testing {
namespace {

const glm::dvec2 kNowhere(std::numeric_limits<double>::quiet_NaN());
constexpr Rgba kGround{0.93F, 0.9F, 0.82F, 1};

template <typename Texel>
LitSphere sphereOf(int size, Texel texel) {
    std::vector<Rgba> pixels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            glm::dvec2 n((2.0 * x + 1) / size - 1, 1 - (2.0 * y + 1) / size);
            n /= std::max(1.0, glm::length(n));
            pixels.push_back(texel(glm::dvec3(n, std::sqrt(std::max(0.0, 1 - glm::dot(n, n))))));
        }
    }
    return LitSphere(size, std::move(pixels));
}

Rgba rgba(glm::dvec3 c) {
    c = glm::clamp(c, 0.0, 1.0);
    return {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1};
}

} // namespace

SyntheticArt drawn(int width, int height, const FormNormal& form, const LitSphere& style) {
    SyntheticArt art;
    art.picture = {width, height, {}};
    art.form = {width, height, {}};
    constexpr int kSub = 3;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::array<float, 3> sum{};
            for (int k = 0; k < kSub * kSub; ++k) {
                const glm::dvec2 n = form({x + (k % kSub + 0.5) / kSub, y + (k / kSub + 0.5) / kSub});
                const Rgba c = std::isnan(n.x) ? kGround : style.at(n.x, n.y);
                sum = {sum[0] + c.r, sum[1] + c.g, sum[2] + c.b};
            }
            const float share = 1.0F / (kSub * kSub);
            art.picture.pixels.push_back({sum[0] * share, sum[1] * share, sum[2] * share, 1});
            const glm::dvec2 n = form({x + 0.5, y + 0.5});
            art.normals.emplace_back(n);
            art.form.values.push_back(std::isnan(n.x) ? 0 : 255);
        }
    }
    return art;
}

FormNormal ballForm(const Ellipse& ellipse) {
    return [ellipse](glm::dvec2 p) {
        const double angle = ellipse.degrees * 3.14159265358979323846 / 180;
        const glm::dvec2 first(std::cos(angle), std::sin(angle));
        const glm::dvec2 second(-first.y, first.x);
        const glm::dvec2 way = p - ellipse.centre;
        const glm::dvec2 u =
            first * (glm::dot(way, first) / ellipse.semiAxes.x) + second * (glm::dot(way, second) / ellipse.semiAxes.y);
        return glm::dot(u, u) <= 1 ? glm::dvec2(u.x, -u.y) : kNowhere;
    };
}

FormNormal ellipsoidForm(glm::dvec2 centre, glm::dvec3 axes) {
    return [=](glm::dvec2 p) {
        const glm::dvec2 u = (p - centre) / glm::dvec2(axes);
        const double height = 1 - glm::dot(u, u);
        const glm::dvec3 outward(u.x / axes.x, -u.y / axes.y, std::sqrt(std::max(0.0, height)) / axes.z);
        return height >= 0 ? glm::dvec2(glm::normalize(outward)) : kNowhere;
    };
}

FormNormal torusForm(glm::dvec2 centre, double around, double thick) {
    return [=](glm::dvec2 p) {
        const glm::dvec2 way = p - centre;
        const double far = glm::length(way);
        const double t = (far - around) / thick;
        return std::abs(t) <= 1 ? glm::dvec2(t * way.x / far, -t * way.y / far) : kNowhere;
    };
}

FormNormal blobForm(glm::dvec2 centre) {
    struct Part {
        glm::dvec3 at;
        double spread;
    };
    return [centre](glm::dvec2 p) {
        static const std::array<Part, 3> kParts{{{{-38, 12, 0}, 62}, {{34, 24, 0}, 54}, {{6, -40, 0}, 48}}};
        const auto field = [&](double z, glm::dvec3& slope) {
            const glm::dvec3 at(p.x - centre.x, -(p.y - centre.y), z); // y up
            double sum = 0;
            slope = glm::dvec3(0);
            for (const Part& part : kParts) {
                const glm::dvec3 d = at - part.at;
                const double value = std::exp(-glm::dot(d, d) / (part.spread * part.spread));
                sum += value;
                slope -= d * (2 * value / (part.spread * part.spread));
            }
            return sum;
        };
        glm::dvec3 slope;
        if (field(0, slope) < 0.5) {
            return kNowhere;
        }
        double low = 0;
        double high = 200;
        for (int i = 0; i < 30; ++i) {
            const double z = (low + high) / 2;
            (field(z, slope) >= 0.5 ? low : high) = z;
        }
        field(low, slope);
        const glm::dvec3 normal = -glm::normalize(slope);
        return glm::dvec2(normal);
    };
}

LitSphere plainStyle(int size) {
    return sphereOf(size, [](glm::dvec3 n) {
        const glm::dvec3 light = glm::normalize(glm::dvec3(-0.5, 0.6, 0.62));
        const double d = 0.5 + 0.5 * glm::dot(n, light);
        const double gleam = std::pow(std::max(0.0, glm::dot(n, glm::normalize(light + glm::dvec3(0, 0, 1)))), 12.0);
        return rgba(glm::dvec3(0.25, 0.16, 0.2) + d * d * glm::dvec3(0.6, 0.55, 0.4) + 0.2 * gleam);
    });
}

LitSphere boldStyle(int size) {
    return sphereOf(size, [](glm::dvec3 n) {
        const double d = glm::dot(n, glm::normalize(glm::dvec3(0.6, 0.5, 0.6)));
        const glm::dvec3 base = d > 0.55 ? glm::dvec3(0.95, 0.75, 0.3) : glm::dvec3(0.7, 0.2, 0.15) * (0.6 + 0.4 * d);
        return rgba(n.z < 0.35 ? 0.4 * base : base);
    });
}

ArtPicture withNoise(ArtPicture picture, double deviation) {
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0, static_cast<float>(deviation));
    for (Rgba& c : picture.pixels) {
        c = {std::clamp(c.r + noise(random), 0.0F, 1.0F), std::clamp(c.g + noise(random), 0.0F, 1.0F),
             std::clamp(c.b + noise(random), 0.0F, 1.0F), c.a};
    }
    return picture;
}

ArtPicture throughJpeg(const ArtPicture& picture, int quality) {
    const auto file = std::filesystem::temp_directory_path() / ("limner-artwork-" + std::to_string(getpid()) + ".jpg");
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("Compression", "jpeg:" + std::to_string(quality));
    const auto output = OIIO::ImageOutput::create(file.string());
    output->open(file.string(), spec);
    output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data(), sizeof(Rgba));
    output->close();
    ArtPicture read = picture;
    const auto input = OIIO::ImageInput::open(file.string());
    input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, read.pixels.data(), sizeof(Rgba));
    input->close();
    std::filesystem::remove(file);
    return read;
}

ArtPicture withLetters(ArtPicture picture) {
    cv::Mat mat(picture.height, picture.width, CV_32FC4, picture.pixels.data());
    for (int y = 20; y < picture.height; y += 34) {
        cv::putText(mat, "Os ilium  crista  spina  anterior", {6 + (y / 34) % 2 * 17, y}, cv::FONT_HERSHEY_SIMPLEX, 0.5,
                    cv::Scalar(0.05, 0.05, 0.05, 1), 1, cv::LINE_AA);
    }
    return picture;
}

ArtPicture lineDrawing() {
    ArtPicture picture = withNoise({300, 300, std::vector<Rgba>(90'000, kGround)}, 0.02);
    cv::Mat mat(300, 300, CV_32FC4, picture.pixels.data());
    const cv::Scalar ink(0.1, 0.1, 0.1, 1);
    cv::circle(mat, {150, 150}, 100, ink, 2, cv::LINE_AA);
    cv::line(mat, {90, 120}, {210, 190}, ink, 2, cv::LINE_AA);
    cv::line(mat, {100, 200}, {190, 90}, ink, 2, cv::LINE_AA);
    return picture;
}

double sphereError(const LitSphere& a, const LitSphere& b, const Mask& covered) {
    double sum = 0;
    double count = 0;
    for (int y = 0; y < covered.height; ++y) {
        for (int x = 0; x < covered.width; ++x) {
            const double nx = (2.0 * x + 1) / covered.width - 1;
            const double ny = 1 - (2.0 * y + 1) / covered.height;
            if (covered.has(x, y) && nx * nx + ny * ny <= 1) {
                const Rgba p = a.at(nx, ny);
                const Rgba q = b.at(nx, ny);
                sum += std::pow(p.r - q.r, 2) + std::pow(p.g - q.g, 2) + std::pow(p.b - q.b, 2);
                count += 3;
            }
        }
    }
    return count > 0 ? std::sqrt(sum / count) : 1;
}

} // namespace limner::testing
