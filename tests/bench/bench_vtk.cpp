// Limner's CPU backend beside VTK's two volume ray casters: the same volume, transfer function, camera, step and light.
#include "bench_scene.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace limner::bench {
namespace {

struct Settings {
    std::filesystem::path volume;
    int size = 512;
    double step = 0.5;
    int rounds = 7;
    std::string look;               ///< "skin" or "fog"; empty: both
    std::filesystem::path pictures; ///< empty: none are kept
};

/// One VTK mapper in a window of its own, set to draw what Limner draws.
class VtkSubject {
  public:
    VtkSubject(std::string name, const Scene& scene, const Settings& settings, vtkVolumeMapper& mapper)
        : name_(std::move(name)), size_(settings.size) {
        window_->SetMultiSamples(0);
        window_->SetOffScreenRendering(1);
        window_->SetSize(size_, size_);
        window_->AddRenderer(renderer_);
        renderer_->SetBackground(0, 0, 0);
        setImage(*scene.volume);
        setLook(scene);
        mapper.SetInputDataObject(image_);
        volume_->SetMapper(&mapper);
        volume_->SetProperty(property_);
        renderer_->AddVolume(volume_);
        aim(sceneFigure(scene, Shading::phong, settings.step).camera);
    }

    void drawOnce() {
        renderer_->GetActiveCamera()->Modified(); // as after a turn: nothing may be reused
        const Stopwatch watch;
        window_->Render();
        window_->WaitForCompletion();
        times_.add(watch);
    }

    [[nodiscard]] std::vector<std::uint8_t> picture() {
        vtkNew<vtkUnsignedCharArray> pixels;
        window_->GetRGBACharPixelData(0, 0, size_ - 1, size_ - 1, 1, pixels);
        std::vector<std::uint8_t> rgb;
        for (int y = size_ - 1; y >= 0; --y) { // VTK's first row is the lowest
            for (int x = 0; x < size_; ++x) {
                const unsigned char* p = pixels->GetPointer((static_cast<vtkIdType>(y) * size_ + x) * 4);
                rgb.insert(rgb.end(), {p[0], p[1], p[2]});
            }
        }
        return rgb;
    }

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const Times& times() const { return times_; }
    /// The line of the window's report that names the OpenGL version, with Mesa's.
    [[nodiscard]] std::string openGlVersion() {
        const std::string report = window_->ReportCapabilities();
        const auto from = report.find("OpenGL version string");
        return from == std::string::npos ? "unknown" : report.substr(from, report.find('\n', from) - from);
    }

  private:
    void setImage(const Volume& volume) {
        const glm::ivec3 dims = volume.grid().dims;
        const glm::dvec3 spacing = volume.grid().spacingMm;
        image_->SetDimensions(dims.x, dims.y, dims.z);
        image_->SetSpacing(spacing.x, spacing.y, spacing.z);
        image_->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
        shift_ = -std::min(0.0, volume.range().low); // unsigned, as the fixed-point mapper likes it
        auto* out = static_cast<unsigned short*>(image_->GetScalarPointer());
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x) {
                    *out++ = static_cast<unsigned short>(std::lround(volume.valueAt({x, y, z}) + shift_));
                }
            }
        }
    }

    void setLook(const Scene& scene) {
        vtkNew<vtkPiecewiseFunction> opacity;
        vtkNew<vtkColorTransferFunction> colour;
        for (const TransferPoint& point : transferPoints(scene.look)) {
            const double at = point.value + scene.valueShift + shift_;
            opacity->AddPoint(at, point.opacity);
            colour->AddRGBPoint(at, point.rgb.r, point.rgb.g, point.rgb.b);
        }
        property_->SetColor(colour);
        property_->SetScalarOpacity(opacity);
        property_->SetScalarOpacityUnitDistance(scene.unitMm);
        property_->SetInterpolationTypeToLinear();
        property_->ShadeOn();
        property_->SetAmbient(0.1);
        property_->SetDiffuse(0.7);
        property_->SetSpecular(0.2);
        property_->SetSpecularPower(10);
    }

    void aim(const Camera& camera) {
        const double distance = camera.heightMm / 2 / std::tan(camera.fovDeg / 2 * M_PI / 180);
        const glm::dvec3 eye = camera.targetMm - camera.direction * distance;
        vtkCamera* vtk = renderer_->GetActiveCamera();
        vtk->SetFocalPoint(camera.targetMm.x, camera.targetMm.y, camera.targetMm.z);
        vtk->SetPosition(eye.x, eye.y, eye.z);
        vtk->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
        vtk->SetViewAngle(camera.fovDeg);
        renderer_->ResetCameraClippingRange();
    }

    std::string name_;
    int size_;
    double shift_ = 0;
    Times times_;
    vtkNew<vtkRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkImageData> image_;
    vtkNew<vtkVolumeProperty> property_;
    vtkNew<vtkVolume> volume_;
};

vtkNew<vtkOpenGLGPUVolumeRayCastMapper> glMapper(double stepMm) {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetLockSampleDistanceToInputSpacing(0);
    mapper->SetUseJittering(0);
    mapper->SetSampleDistance(static_cast<float>(stepMm));
    mapper->SetImageSampleDistance(1);
    mapper->SetMaxMemoryInBytes(vtkIdType{4} << 30); // never let it draw a reduced volume
    mapper->SetMaxMemoryFraction(1);
    return mapper;
}

vtkNew<vtkFixedPointVolumeRayCastMapper> fixedPointMapper(double stepMm) {
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetSampleDistance(static_cast<float>(stepMm));
    mapper->SetInteractiveSampleDistance(static_cast<float>(stepMm));
    mapper->SetImageSampleDistance(1);
    return mapper;
}

std::vector<Subject> limnerSubjects(const Scene& scene, const Settings& settings) {
    Planner planner;
    Task task;
    std::vector<Subject> subjects;
    const auto add = [&](const std::string& name, Shading shading, std::optional<SampleLattice> lattice) {
        PlanRequest request;
        request.size = {settings.size, settings.size};
        request.lattice = lattice;
        subjects.emplace_back();
        subjects.back().name = name;
        subjects.back().plan = planner.plan(sceneFigure(scene, shading, settings.step), request, task);
    };
    // VTK's rays start at the outermost voxel centres and sample there.
    const SampleLattice vtkLattice{settings.step * scene.volume->grid().smallestSpacingMm(), 0, 0.5};
    add("Limner CPU, Phong", Shading::phong, std::nullopt);
    add("Limner CPU, Phong, VTK's sample positions", Shading::phong, vtkLattice);
    add("Limner CPU, lit spheres", Shading::style, std::nullopt);
    return subjects;
}

void writePpm(const std::filesystem::path& path, int size, const std::vector<std::uint8_t>& rgb) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << size << ' ' << size << "\n255\n";
    file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
}

struct Row {
    std::string name;
    const Times* times;
    std::vector<std::uint8_t> rgb;
};

void printTable(const std::vector<Row>& rows, const Row& gl, const Row& fixed, const Settings& settings) {
    printRow({"renderer", "median ms (min-max)", "processor ms", "first ms", "VTK GL / this", "VTK fixed / this",
              "by processor time: GL, fixed", "RMSE to VTK GL"});
    printRow({"---", "---", "---", "---", "---", "---", "---", "---"});
    for (const Row& row : rows) {
        const Times& times = *row.times;
        printRow({row.name, times.spread(), number(times.cpuMedian()), number(times.firstMs()),
                  number(gl.times->median() / times.median(), 1), number(fixed.times->median() / times.median(), 2),
                  number(gl.times->cpuMedian() / times.cpuMedian(), 1) + ", " +
                      number(fixed.times->cpuMedian() / times.cpuMedian(), 2),
                  number(rmse(row.rgb, gl.rgb), 4)});
        if (!settings.pictures.empty()) {
            std::filesystem::create_directories(settings.pictures);
            writePpm(settings.pictures / (row.name + ".ppm"), settings.size, row.rgb);
        }
    }
}

void compare(Scene scene, Look look, const Settings& settings) {
    scene.look = look;
    std::cout << "\n" << (look == Look::skin ? "Skin over bone" : "Fog: all tissue shows, nothing to skip") << "\n\n";
    const auto backend = makeCpuBackend();
    std::vector<Subject> limner = limnerSubjects(scene, settings);
    const double stepMm = settings.step * scene.volume->grid().smallestSpacingMm();
    const auto glRayCaster = glMapper(stepMm);
    const auto fixedRayCaster = fixedPointMapper(stepMm);
    VtkSubject gl("VTK GL mapper", scene, settings, *glRayCaster);
    VtkSubject fixed("VTK fixed-point mapper", scene, settings, *fixedRayCaster);
    for (int round = 0; round <= settings.rounds; ++round) {
        for (Subject& subject : limner) {
            drawOnce(subject, *backend);
        }
        fixed.drawOnce();
        gl.drawOnce();
    }
    const Row glRow{gl.name(), &gl.times(), gl.picture()};
    const Row fixedRow{fixed.name(), &fixed.times(), fixed.picture()};
    std::vector<Row> rows;
    for (Subject& subject : limner) {
        rows.push_back({subject.name, &subject.times, rgb8OverBlack(subject.last.picture)});
    }
    rows.push_back(fixedRow);
    rows.push_back(glRow);
    printTable(rows, glRow, fixedRow, settings);
    const RenderResult& picture = limner.front().last;
    std::cout << "\nLimner took " << number(static_cast<double>(picture.samples) / 1e6, 1) << " M samples and shaded "
              << number(static_cast<double>(picture.shaded) / 1e6, 1) << " M; lit spheres / Phong "
              << number(limner[2].times.median() / limner[0].times.median(), 3) << " (by processor time "
              << number(limner[2].times.cpuMedian() / limner[0].times.cpuMedian(), 3) << "); " << gl.openGlVersion()
              << "\n";
}

int runAll(int argc, char** argv) {
    Settings settings;
    settings.volume = option(argc, argv, "volume", LIMNER_TEST_DATA "/volumes/cthead_unc.nrrd");
    settings.size = std::stoi(option(argc, argv, "size", "512"));
    settings.step = std::stod(option(argc, argv, "step", "0.5"));
    settings.rounds = std::stoi(option(argc, argv, "rounds", "7"));
    settings.look = option(argc, argv, "look", "");
    settings.pictures = option(argc, argv, "pictures", "");
    if (!std::filesystem::exists(settings.volume)) {
        std::cout << "no " << settings.volume.filename().string() << ": the built-in head is drawn instead\n";
        settings.volume.clear();
    }
    const Scene scene = loadScene(settings.volume);
    const Grid& grid = scene.volume->grid();
    std::cout << "volume " << (settings.volume.empty() ? "built-in head" : settings.volume.filename().string()) << ", "
              << grid.dims.x << " x " << grid.dims.y << " x " << grid.dims.z << ", picture " << settings.size
              << "^2, step " << settings.step << " voxel, " << settings.rounds << " pictures in turn\n"
              << machineFacts() << ", VTK " << vtkVersion::GetVTKVersion() << "\n";
    if (settings.look != "fog") {
        compare(scene, Look::skin, settings);
    }
    if (settings.look != "skin") {
        compare(scene, Look::fog, settings);
    }
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
