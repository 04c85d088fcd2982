#pragma once

#include "core/figure/figure.h"
#include "core/volume/volume.h"
#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner::bench {

/// One point of the benchmarks' transfer functions: value, opacity per unit length, colour.
struct TransferPoint {
    double value;
    double opacity;
    glm::dvec3 rgb;
};

enum class Look {
    skin, ///< thin translucent skin over opaque bone: much empty space
    fog,  ///< all tissue contributes and little saturates: nothing to skip
};

/// Points for a CT head in HU + 1024.
const std::vector<TransferPoint>& transferPoints(Look look);

/// What is drawn: the same for every renderer compared.
struct Scene {
    std::shared_ptr<const Volume> volume; ///< on a straight grid with its first voxel centre at (0, 0, 0) mm
    double valueShift = 0;                ///< added to the transfer points' values to meet the volume's unit
    double unitMm = 1;                    ///< length that the points' opacity is of
    Look look = Look::skin;
};

/// Reads any supported volume, or makes the built-in head where `path` is empty.
Scene loadScene(const std::filesystem::path& path);
/// The built-in head at `size`^3.
Scene phantomScene(int size);

/// Eye at 1.9 times the volume's longest edge from its middle, 15 degrees up, 30 degrees field of view. Azimuth 0 looks
/// along +y.
Camera sceneCamera(const Volume& volume, double azimuthDeg);

/// Early termination at 1/255, Phong 0.1/0.7/0.2/10 with the light at the eye, or lit spheres.
Figure sceneFigure(const Scene& scene, Shading shading, double stepVoxels);

/// The same scan in another storage.
std::shared_ptr<const Volume> converted(const Volume& volume, VoxelType type);

/// Processor time of all threads of this process so far, in ms.
double processorMs();

/// Measures from its construction on.
class Stopwatch {
  public:
    [[nodiscard]] double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }
    [[nodiscard]] double cpuMs() const { return processorMs() - cpuStart_; }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double cpuStart_ = processorMs();
};

/// Times of one subject, in ms; the first picture stands apart.
class Times {
  public:
    void add(const Stopwatch& watch);
    [[nodiscard]] double median() const { return medianOf(ms_); }
    /// Processor time, which a busy machine disturbs less.
    [[nodiscard]] double cpuMedian() const { return medianOf(cpuMs_); }
    [[nodiscard]] double firstMs() const { return firstMs_; }
    /// "12.3 (11.0-14.1)": median, least and most.
    [[nodiscard]] std::string spread() const;

  private:
    static double medianOf(std::vector<double> values);
    std::vector<double> ms_;
    std::vector<double> cpuMs_;
    double firstMs_ = 0;
};

/// A Limner subject: a plan, drawn again and again.
struct Subject {
    std::string name;
    std::shared_ptr<const RenderPlan> plan;
    int threads = 0; ///< 0: all
    Times times;
    RenderResult last;
};

/// Draws the subject once.
void drawOnce(Subject& subject, const Backend& backend);
/// Draws the subjects in turn, `rounds` times each after a first picture.
void drawInTurn(std::vector<Subject>& subjects, const Backend& backend, int rounds);

/// Figures at 512^2 beside the first of them, printed as a table of frame times.
class FrameTable {
  public:
    FrameTable(std::string title, int rounds) : title_(std::move(title)), rounds_(rounds) {}
    void add(const std::string& name, const Figure& figure);
    void run();

  private:
    std::string title_;
    int rounds_;
    std::vector<Subject> subjects_;
};

/// 8-bit RGB over black, top row first.
std::vector<std::uint8_t> rgb8OverBlack(const Picture& picture);
/// Root of the mean squared difference over all components, of 1.
double rmse(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);

/// "AMD EPYC, 2 threads, AVX2": what the numbers were measured on.
std::string machineFacts();
/// Peak resident memory of this process in MB.
double peakRssMb();
/// Resident memory of this process now in MB.
double rssMb();

/// Prints a row of a Markdown table.
void printRow(const std::vector<std::string>& cells);
/// `value` with `decimals` places.
std::string number(double value, int decimals = 0);

/// A benchmark's `main`: what `run` throws is one line on stderr and exit code 1.
int runBench(int (*run)(int, char**), int argc, char** argv);

/// The value behind `--name` on the command line, or `fallback`.
std::string option(int argc, char** argv, const std::string& name, const std::string& fallback);

} // namespace limner::bench
