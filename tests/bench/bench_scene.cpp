#include "bench_scene.h"

#include "core/volume/import.h"
#include "core/volume/phantom.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

namespace limner::bench {

namespace {

/// The scan on a grid along the axes, so that every renderer's geometry is beyond doubt.
std::shared_ptr<const Volume> straightened(const Volume& volume) {
    Volume::Contents contents = volume.contents();
    contents.grid.direction = glm::dmat3(1);
    contents.grid.originMm = glm::dvec3(0);
    const glm::ivec3 dims = contents.grid.dims;
    const std::size_t rowBytes = static_cast<std::size_t>(dims.x) * bytesPerVoxel(contents.type);
    std::vector<std::byte> stored(rowBytes * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z));
    std::byte* row = stored.data();
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y, row += rowBytes) {
            volume.copyRow(y, z, row);
        }
    }
    return std::make_shared<Volume>(contents, stored);
}

/// A shaded ball with a highlight and a dark rim: as costly to look up as any painted one.
std::shared_ptr<const LitSphere> shadedBall(const glm::dvec3& rgb) {
    const int size = 512;
    std::vector<Rgba> pixels(static_cast<std::size_t>(size) * size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = (x + 0.5) / size * 2 - 1;
            const double v = 1 - (y + 0.5) / size * 2;
            const double z = std::sqrt(std::max(0.0, 1 - u * u - v * v));
            const double light = std::max(0.0, -0.4 * u + 0.5 * v + 0.77 * z);
            const double shine = 0.4 * std::pow(light, 20.0);
            const double rim = 0.35 + 0.65 * z;
            const auto channel = [&](double c) {
                return static_cast<float>(std::clamp(c * (0.25 + 0.75 * light) * rim + shine, 0.0, 1.0));
            };
            pixels[static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x)] = {channel(rgb.r), channel(rgb.g),
                                                                                        channel(rgb.b), 1.0F};
        }
    }
    return std::make_shared<LitSphere>(size, std::move(pixels));
}

std::string ballName(const glm::dvec3& rgb) {
    return "ball " + number(rgb.r, 2) + " " + number(rgb.g, 2) + " " + number(rgb.b, 2);
}

Layer sceneLayer(const Scene& scene, Shading shading) {
    Layer layer;
    layer.name = "head";
    layer.shading = shading;
    if (shading == Shading::phong) {
        layer.specular = Specular{0.2, 10};
    }
    // Opacity in a figure is of the smallest spacing; the points' is of `unitMm`.
    const double exponent = scene.volume->grid().smallestSpacingMm() / scene.unitMm;
    for (const TransferPoint& point : transferPoints(scene.look)) {
        const double at = point.value + scene.valueShift;
        layer.transfer.opacity.emplace_back(at, 1 - std::pow(1 - point.opacity, exponent));
        TransferNode node;
        node.at = at;
        if (shading == Shading::style) {
            node.style = ballName(point.rgb);
        } else {
            node.rgb = point.rgb;
        }
        layer.transfer.nodes.push_back(node);
    }
    return layer;
}

double statusMb(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(key + ":")) {
            return std::stod(line.substr(key.size() + 1)) / 1024; // kB
        }
    }
    return 0;
}

} // namespace

const std::vector<TransferPoint>& transferPoints(Look look) {
    static const std::vector<TransferPoint> skin = {
        {0, 0, {0.9, 0.6, 0.45}},     {450, 0, {0.9, 0.6, 0.45}},     {700, 0.15, {0.9, 0.6, 0.45}},
        {980, 0, {0.9, 0.55, 0.4}},   {1250, 0, {0.95, 0.9, 0.75}},   {1500, 0.3, {0.95, 0.9, 0.75}},
        {2000, 0.8, {1.0, 1.0, 0.9}}, {4095, 0.95, {1.0, 1.0, 0.95}},
    };
    static const std::vector<TransferPoint> fog = {
        {0, 0, {1, 0.6, 0.4}},          {500, 0, {1, 0.6, 0.4}},   {850, 0.004, {1, 0.7, 0.5}},
        {1100, 0.006, {0.9, 0.5, 0.4}}, {1300, 0.01, {1, 1, 0.9}}, {4095, 0.03, {1, 1, 0.9}},
    };
    return look == Look::skin ? skin : fog;
}

Scene loadScene(const std::filesystem::path& path) {
    if (path.empty()) {
        return phantomScene(256);
    }
    Task task;
    const ImportedVolume imported = importVolume(path, {}, task);
    Scene scene;
    scene.volume = straightened(*imported.volume);
    // Data that go below zero are HU themselves.
    scene.valueShift = imported.volume->range().low < 0 ? -1024 : 0;
    return scene;
}

Scene phantomScene(int size) {
    Scene scene;
    scene.volume = straightened(*makeHeadPhantom(size));
    scene.valueShift = -1024; // HU
    scene.unitMm = scene.volume->grid().sizeMm().x / 256;
    return scene;
}

Camera sceneCamera(const Volume& volume, double azimuthDeg) {
    const double azimuth = azimuthDeg * std::numbers::pi / 180;
    const double elevation = 15 * std::numbers::pi / 180;
    const glm::dvec3 size = volume.grid().sizeMm();
    const double distance = 1.9 * std::max({size.x, size.y, size.z});
    Camera camera;
    camera.projection = Projection::perspective;
    camera.targetMm = volume.grid().centreMm();
    camera.direction = -glm::dvec3(std::cos(elevation) * std::sin(azimuth), -std::cos(elevation) * std::cos(azimuth),
                                   std::sin(elevation));
    camera.up = {0, 0, 1};
    camera.fovDeg = 30;
    camera.heightMm = 2 * distance * std::tan(camera.fovDeg / 2 * std::numbers::pi / 180);
    return camera;
}

Figure sceneFigure(const Scene& scene, Shading shading, double stepVoxels) {
    Figure figure;
    figure.volume.emplace();
    figure.volume->data = scene.volume;
    figure.camera = sceneCamera(*scene.volume, 30);
    figure.layers.push_back(sceneLayer(scene, shading));
    if (shading == Shading::style) {
        for (const TransferPoint& point : transferPoints(scene.look)) {
            StyleEntry entry;
            entry.id = ballName(point.rgb);
            if (figure.findStyle(entry.id) == nullptr) { // equal colours share a ball, as a painter would
                entry.sphere = shadedBall(point.rgb);
                figure.styles.push_back(entry);
            }
        }
    }
    figure.background.rgba = {0, 0, 0, 1};
    figure.output = {130.0, 130.0, 100.0, false};
    figure.quality.stepVoxels = stepVoxels;
    figure.quality.earlyTermination = 1.0 / 255; // what 8-bit rivals stop at
    return figure;
}

std::shared_ptr<const Volume> converted(const Volume& volume, VoxelType type) {
    Volume::Contents contents = volume.contents();
    const ValueRange range = volume.range();
    // Steps of the new storage over the range: all codes of 8 bits, one per unit for 16, [0, 1] for floats.
    const double codes = type == VoxelType::uint8 ? 255 : (type == VoxelType::int16 ? range.high - range.low : 1);
    contents.type = type;
    contents.slope = (range.high - range.low) / codes;
    contents.intercept = range.low;
    const glm::ivec3 dims = contents.grid.dims;
    std::vector<std::byte> stored(contents.grid.voxelCount() * bytesPerVoxel(type));
    std::size_t at = 0;
    const auto put = [&](auto number) {
        std::memcpy(stored.data() + at, &number, sizeof number);
        at += sizeof number;
    };
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const double code = (volume.valueAt({x, y, z}) - contents.intercept) / contents.slope;
                switch (type) {
                case VoxelType::uint8: put(static_cast<std::uint8_t>(std::lround(code))); break;
                case VoxelType::int16: put(static_cast<std::int16_t>(std::lround(code))); break;
                case VoxelType::float32: put(static_cast<float>(code)); break;
                }
            }
        }
    }
    return std::make_shared<Volume>(contents, stored);
}

double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void Times::add(const Stopwatch& watch) {
    if (firstMs_ == 0) {
        firstMs_ = watch.ms();
        return;
    }
    ms_.push_back(watch.ms());
    cpuMs_.push_back(watch.cpuMs());
}

double Times::medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
}

std::string Times::spread() const {
    if (ms_.empty()) {
        return "-";
    }
    const auto [least, most] = std::minmax_element(ms_.begin(), ms_.end());
    return number(median(), 1) + " (" + number(*least, 1) + "-" + number(*most, 1) + ")";
}

void drawOnce(Subject& subject, const Backend& backend) {
    const auto threads =
        static_cast<std::size_t>(subject.threads > 0 ? subject.threads : tbb::this_task_arena::max_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Task task;
    const Stopwatch watch;
    subject.last = backend.render(*subject.plan, Tile{{0, 0}, subject.plan->size}, task);
    subject.times.add(watch);
}

void drawInTurn(std::vector<Subject>& subjects, const Backend& backend, int rounds) {
    for (int round = 0; round <= rounds; ++round) { // one more: the first picture does not count
        for (Subject& subject : subjects) {
            drawOnce(subject, backend);
        }
    }
}

void FrameTable::add(const std::string& name, const Figure& figure) {
    Task task;
    PlanRequest request;
    request.size = {512, 512};
    Planner planner;
    subjects_.emplace_back();
    subjects_.back().name = name;
    subjects_.back().plan = planner.plan(figure, request, task);
}

void FrameTable::run() {
    drawInTurn(subjects_, *makeCpuBackend(), rounds_);
    std::cout << "\n" << title_ << "\n\n";
    printRow({"figure", "median ms (min-max)", "processor ms", "frames: first / this, by processor time", "M samples",
              "M shaded"});
    printRow({"---", "---", "---", "---", "---", "---"});
    for (const Subject& subject : subjects_) {
        printRow({subject.name, subject.times.spread(), number(subject.times.cpuMedian(), 1),
                  number(subjects_.front().times.cpuMedian() / subject.times.cpuMedian(), 3),
                  number(static_cast<double>(subject.last.samples) * 1e-6, 1),
                  number(static_cast<double>(subject.last.shaded) * 1e-6, 1)});
    }
}

std::vector<std::uint8_t> rgb8OverBlack(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.rgba().size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba().size(); ++i) {
        if (i % 4 != 3) {
            bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(picture.rgba()[i], 0.0F, 1.0F) * 255)));
        }
    }
    return bytes;
}

double rmse(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = (a[i] - b.at(i)) / 255.0;
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

std::string machineFacts() {
    std::ifstream info("/proc/cpuinfo");
    std::string model = "unknown processor";
    std::string flags;
    int threads = 0;
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name")) {
            model = line.substr(colon + 2);
            ++threads;
        } else if (line.starts_with("flags")) {
            flags = line.substr(colon + 1) + " ";
        }
    }
    std::string isa;
    for (const char* flag : {"sse4_1", "avx2", "fma", "f16c", "avx512f"}) {
        if (flags.find(std::string(" ") + flag + " ") != std::string::npos) {
            isa += std::string(" ") + flag;
        }
    }
    return model + ", " + std::to_string(threads) + " threads," + isa;
}

double peakRssMb() { return statusMb("VmHWM"); }
double rssMb() { return statusMb("VmRSS"); }

void printRow(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) {
        std::cout << "| " << cell << ' ';
    }
    std::cout << "|" << std::endl; // flushed: a long run is watched
}

std::string number(double value, int decimals) {
    std::ostringstream out;
    out.setf(std::ios::fixed);
    out.precision(decimals);
    out << value;
    return out.str();
}

int runBench(int (*run)(int, char**), int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

std::string option(int argc, char** argv, const std::string& name, const std::string& fallback) {
    for (int i = 1; i + 1 < argc; ++i) {
        if (argv[i] == "--" + name) {
            return argv[i + 1];
        }
    }
    return fallback;
}

} // namespace limner::bench
