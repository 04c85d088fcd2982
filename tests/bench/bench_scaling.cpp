// How Limner's CPU backend scales, what its choices cost, and what a volume costs to load, plan and keep.
#include "bench_scene.h"

#include "core/volume/import.h"
#include "renderer/plan/skip_grid.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace limner::bench {
namespace {

/// One subject of a table: a figure at a size, with the number of threads.
struct Case {
    std::string name;
    Scene scene;
    Shading shading = Shading::phong;
    int size = 512;
    double step = 0.5;
    int threads = 0;
};

/// What the command line asks for.
struct Wanted {
    int rounds = 7;
    std::string only; ///< a table whose title starts so; empty: all
    [[nodiscard]] bool covers(const std::string& title) const { return only.empty() || title.starts_with(only); }
};

void runTable(const std::string& title, const std::vector<Case>& cases, const Wanted& wanted) {
    if (!wanted.covers(title)) {
        return;
    }
    std::cout << "\n" << title << "\n\n";
    const auto backend = makeCpuBackend();
    std::vector<Subject> subjects;
    std::vector<double> planMs;
    for (const Case& one : cases) {
        Planner planner;
        Task task;
        PlanRequest picture;
        picture.size = {one.size, one.size};
        const Figure figure = sceneFigure(one.scene, one.shading, one.step);
        const Stopwatch watch;
        subjects.emplace_back();
        subjects.back().name = one.name;
        subjects.back().threads = one.threads;
        subjects.back().plan = planner.plan(figure, picture, task);
        planMs.push_back(watch.ms());
    }
    drawInTurn(subjects, *backend, wanted.rounds);
    printRow({"subject", "median ms (min-max)", "processor ms", "to the first row", "by processor time", "M samples",
              "M shaded", "first plan ms"});
    printRow({"---", "---", "---", "---", "---", "---", "---", "---"});
    const Times& base = subjects.front().times;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const Subject& subject = subjects[i];
        const Times& times = subject.times;
        printRow({subject.name, times.spread(), number(times.cpuMedian(), 1), number(times.median() / base.median(), 3),
                  number(times.cpuMedian() / base.cpuMedian(), 3),
                  number(static_cast<double>(subject.last.samples) / 1e6, 1),
                  number(static_cast<double>(subject.last.shaded) / 1e6, 1), number(planMs[i], 1)});
    }
}

Scene stored(const Scene& scene, VoxelType type) {
    Scene changed = scene;
    changed.volume = converted(*scene.volume, type);
    return changed;
}

void runPictureTables(const Scene& scan, const Wanted& wanted) {
    runTable("Pixels", {{"512^2", scan}, {"256^2", scan, Shading::phong, 256}, {"1024^2", scan, Shading::phong, 1024}},
             wanted);
    runTable("Step in voxels",
             {{"0.5", scan}, {"1", scan, Shading::phong, 512, 1}, {"0.25", scan, Shading::phong, 512, 0.25}}, wanted);
    runTable("Shading", {{"Phong", scan}, {"lit spheres", scan, Shading::style}, {"flat", scan, Shading::flat}},
             wanted);
    Scene fog = scan;
    fog.look = Look::fog;
    runTable("Shading where all tissue shows", {{"Phong", fog}, {"lit spheres", fog, Shading::style}}, wanted);
    runTable("Threads", {{"all", scan}, {"one", scan, Shading::phong, 512, 0.5, 1}}, wanted);
    runTable("Storage",
             {{"16 bit", stored(scan, VoxelType::int16)},
              {"8 bit", stored(scan, VoxelType::uint8)},
              {"float", stored(scan, VoxelType::float32)}},
             wanted);
}

void runVolumeTable(const Wanted& wanted) {
    const std::string title = "Volume (built-in head, the same picture)";
    if (!wanted.covers(title)) {
        return; // the volumes take their time to make
    }
    runTable(title, {{"256^3", phantomScene(256)}, {"128^3", phantomScene(128)}, {"512^3", phantomScene(512)}}, wanted);
}

/// What an edit of the opacity curve costs before the first new pixel, beside the skip grid on its own.
void runEditTable(const Scene& scan, const Wanted& wanted) {
    const std::string title = "Edit of the opacity curve";
    if (!wanted.covers(title)) {
        return;
    }
    std::cout << "\n" << title << "\n\n";
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {512, 512};
    Figure figure = sceneFigure(scan, Shading::phong, 0.5);
    const Stopwatch firstWatch;
    planner.plan(figure, request, task);
    const double first = firstWatch.ms();
    Times turn;
    Times edit;
    for (int round = 0; round <= wanted.rounds; ++round) {
        figure.camera = sceneCamera(*scan.volume, 30 + round);
        const Stopwatch turnWatch;
        planner.plan(figure, request, task);
        turn.add(turnWatch);
        figure.layers[0].transfer.opacity[2].y = 0.1 + 0.01 * round;
        const Stopwatch editWatch;
        planner.plan(figure, request, task);
        edit.add(editWatch);
    }
    const Stopwatch minMaxWatch;
    const auto minMax = computeMinMaxGrid(*scan.volume);
    const double minMaxMs = minMaxWatch.ms();
    VisibleRange range{scan.volume->storedFromValue(scan.volume->range().low),
                       scan.volume->storedFromValue(scan.volume->range().high), std::vector<std::uint8_t>(1024, 0)};
    std::fill(range.visible.begin() + 300, range.visible.end(), std::uint8_t{1}); // skin and bone, air is empty
    Times skip;
    for (int round = 0; round <= wanted.rounds; ++round) {
        const Stopwatch watch;
        computeSkipGrid(*minMax, range);
        skip.add(watch);
    }
    printRow({"step", "ms"});
    printRow({"---", "---"});
    printRow({"first plan of a volume", number(first, 1)});
    printRow({"of it, lowest and highest of every block", number(minMaxMs, 1)});
    printRow({"plan after a turn", number(turn.median(), 2)});
    printRow({"plan after an edit of the curve", number(edit.median(), 2)});
    printRow({"of it, skip grid", number(skip.median(), 2)});
}

/// Runs in a process of its own, so that the peak is this volume's alone.
int measureMemory(const std::string& path) {
    const double before = rssMb();
    const Stopwatch loadWatch;
    Task task;
    const ImportedVolume imported = importVolume(path, {}, task);
    const double loadMs = loadWatch.ms();
    const double loadPeak = peakRssMb();
    const double loaded = rssMb();
    Scene scene;
    scene.volume = imported.volume;
    scene.valueShift = imported.volume->range().low < 0 ? -1024 : 0;
    Planner planner;
    PlanRequest request;
    request.size = {512, 512};
    const auto plan = planner.plan(sceneFigure(scene, Shading::phong, 0.5), request, task);
    makeCpuBackend()->render(*plan, Tile{{0, 0}, plan->size}, task);
    const Grid& grid = imported.volume->grid();
    const double voxelMb = static_cast<double>(grid.voxelCount() * bytesPerVoxel(imported.volume->type())) / 1048576;
    printRow({std::filesystem::path(path).filename().string(),
              std::to_string(grid.dims.x) + "x" + std::to_string(grid.dims.y) + "x" + std::to_string(grid.dims.z),
              number(voxelMb, 1), number(static_cast<double>(imported.volume->bytes()) / 1048576, 1), number(before, 1),
              number(loadPeak, 1), number(loaded, 1), number(rssMb(), 1), number(peakRssMb(), 1),
              number((peakRssMb() - before) / voxelMb, 2), number(loadMs)});
    return 0;
}

void runMemoryTable(const std::vector<std::string>& volumes, const Wanted& wanted) {
    const std::string title = "Memory in MB and loading (a process for each; 512^2 by Phong drawn at the end)";
    if (!wanted.covers(title)) {
        return;
    }
    std::cout << "\n" << title << "\n\n";
    printRow({"volume", "dims", "voxels", "bricks", "process before", "peak of loading", "loaded", "drawn", "peak",
              "(peak - before) / voxels", "load ms"});
    printRow({"---", "---", "---", "---", "---", "---", "---", "---", "---", "---", "---"});
    const auto self = std::filesystem::read_symlink("/proc/self/exe").string();
    for (const std::string& volume : volumes) {
        if (!std::filesystem::exists(volume)) {
            continue;
        }
        std::cout.flush();
        const std::string command = "'" + self + "' --memory '" + volume + "'";
        if (std::system(command.c_str()) != 0) {
            std::cout << "(no figures for " << std::filesystem::path(volume).filename().string() << ")\n";
        }
    }
}

int runAll(int argc, char** argv) {
    if (const std::string path = option(argc, argv, "memory", ""); !path.empty()) {
        return measureMemory(path);
    }
    const std::string data = option(argc, argv, "data", LIMNER_TEST_DATA);
    const Wanted wanted{std::stoi(option(argc, argv, "rounds", "7")), option(argc, argv, "table", "")};
    const std::string scanPath = data + "/volumes/cthead_unc.nrrd";
    const bool haveScan = std::filesystem::exists(scanPath);
    const Scene scan = haveScan ? loadScene(scanPath) : phantomScene(256);
    std::cout << (haveScan ? "volume cthead_unc.nrrd" : "volume: the built-in head at 256^3") << "; " << machineFacts()
              << "; " << wanted.rounds << " pictures of each in turn\n";
    runPictureTables(scan, wanted);
    runEditTable(scan, wanted);
    runVolumeTable(wanted);
    runMemoryTable({scanPath, data + "/volumes/cranium_ct.nrrd", data + "/volumes/bonsai.vti",
                    data + "/volumes/brain_colin27_t1.nii.gz", data + "/stacks/visible_human_head_png"},
                   wanted);
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
