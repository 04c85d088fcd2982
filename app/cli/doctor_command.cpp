#include "app/cli/doctor_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/figure/quantity.h"
#include "renderer/backend_choice.h"
#include "renderer/cpu/kernel.h"
#include "renderer/gl/context.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <thread>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner doctor
  limner doctor --json > machine.json
)";

/// What one OpenGL library gives, or why it does not.
Facts libraryFacts(const std::string& library) {
    try {
        const gl::ContextFacts f = gl::probe(gl::contextFactory(library));
        return {{"library", library},
                {"works", true},
                {"renderer", f.renderer},
                {"vendor", f.vendor},
                {"version", f.version},
                {"glsl", f.glsl},
                {"software", f.software},
                {"largest_3d_texture", f.largest3d},
                {"largest_picture", f.largest2d},
                {"largest_table", f.largestTable},
                {"texture_units", f.textureUnits}};
    } catch (const Error& error) {
        return {{"library", library}, {"works", false}, {"why", error.text().why}};
    }
}

/// Variables of the environment that Mesa's drawing by the processor suffers from, as measured with Mesa 22.3 and 25.
Facts environmentFacts() {
    struct Known {
        const char* name;
        const char* bad;
        const char* harm;
    };
    constexpr Known kKnown[] = {
        {"LP_NATIVE_VECTOR_WIDTH", "512", "ray casting with llvmpipe ends in a crash; take it out"},
        {"LP_NATIVE_VECTOR_WIDTH", "128", "llvmpipe draws up to 1.4 times slower; take it out"},
        {"LP_NUM_THREADS", "0", "llvmpipe draws with one processor; take it out"},
        {"LP_NUM_THREADS", "1", "llvmpipe draws with one processor; take it out"},
    };
    Facts found = Facts::array();
    for (const Known& known : kKnown) {
        const char* value = std::getenv(known.name);
        if (value != nullptr && std::string(value) == known.bad) {
            found.push_back({{"variable", std::string(known.name) + "=" + value}, {"harm", known.harm}});
        }
    }
    return found;
}

Facts allFacts() {
    const BackendChoice& choice = automaticBackend();
    Facts libraries = Facts::array();
    for (const std::string& library : gl::contextLibraries()) {
        if (library != "auto") {
            libraries.push_back(libraryFacts(library));
        }
    }
    return {{"version", LIMNER_VERSION},
            {"processor", processorName()},
            {"threads", std::thread::hardware_concurrency()},
            {"instruction_sets", kernelTargets()},
            {"memory_bytes", machineMemory()},
            {"backend", choice.name},
            {"backend_reason", choice.reason},
            {"opengl", libraries},
            {"environment", environmentFacts()}};
}

std::string libraryText(const Facts& f) {
    const std::string library = f.at("library").get<std::string>();
    if (!f.at("works").get<bool>()) {
        return factLine("OpenGL, " + library, f.at("why").get<std::string>());
    }
    const auto number = [&](const char* key) { return std::to_string(f.at(key).get<int>()); };
    const bool software = f.at("software").get<bool>();
    return factLine("OpenGL, " + library,
                    f.at("renderer").get<std::string>() + (software ? ", drawn by the processor" : "")) +
           factLine("", f.at("version").get<std::string>() + ", GLSL " + f.at("glsl").get<std::string>() + ", " +
                            f.at("vendor").get<std::string>()) +
           factLine("", "3D textures up to " + number("largest_3d_texture") + ", pictures up to " +
                            number("largest_picture") + ", tables up to " + number("largest_table") + ", " +
                            number("texture_units") + " texture units");
}

std::string textOf(const Facts& facts) {
    std::string sets;
    for (const auto& set : facts.at("instruction_sets")) {
        sets += (sets.empty() ? "" : ", ") + set.get<std::string>();
    }
    std::string text = factLine("Limner", facts.at("version").get<std::string>());
    text += factLine("Processor", facts.at("processor").get<std::string>() + ", " +
                                      std::to_string(facts.at("threads").get<unsigned>()) + " threads");
    text += factLine("Instructions", sets + " (the first is used)");
    text += factLine("Memory", formatBytes(facts.at("memory_bytes").get<std::uint64_t>()));
    text += factLine("Backend",
                     facts.at("backend").get<std::string>() + ": " + facts.at("backend_reason").get<std::string>());
    for (const Facts& library : facts.at("opengl")) {
        text += libraryText(library);
    }
    for (const Facts& variable : facts.at("environment")) {
        text += factLine("Environment",
                         variable.at("variable").get<std::string>() + ": " + variable.at("harm").get<std::string>());
    }
    return text;
}

} // namespace

void DoctorCommand::declare(CLI::App& app) {
    app.description("Shows what this machine draws with\n"
                    "Which backend auto stands for and why; processor and memory; the OpenGL libraries, what each\n"
                    "gives or why it does not work. To be put into a report of a fault.");
    app.footer(kExamples);
}

int DoctorCommand::run(Console& console) {
    const Facts facts = allFacts();
    if (console.json) {
        printFacts(console, facts);
    } else {
        console.print(textOf(facts));
    }
    return 0;
}

} // namespace limner::cli
