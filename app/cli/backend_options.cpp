#include "app/cli/backend_options.h"

#include "app/cli/words.h"
#include "renderer/backend_choice.h"

#include <CLI/CLI.hpp>

namespace limner::cli {

void BackendOptions::declare(CLI::App& app) {
    app.add_option("--backend", backend_,
                   "What renders: auto (a graphics card where there is one), cpu, gl (OpenGL)\n"
                   "or reference (slow, double precision) [auto]")
        ->option_text("NAME");
    app.add_option("--gl", library_,
                   "The OpenGL library of --backend gl: auto, egl (a card, or none) or osmesa\n"
                   "(drawn by the processor) [auto]")
        ->option_text("NAME");
}

std::unique_ptr<Backend> BackendOptions::make() const {
    checkKnown(backendNames(), backend_, "--backend");
    checkKnown(glLibraryNames(), library_, "--gl");
    return makeBackend(backend_, library_);
}

} // namespace limner::cli
