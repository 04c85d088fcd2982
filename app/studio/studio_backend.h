#pragma once

#include "renderer/backend.h"

#include <QString>

#include <memory>
#include <span>

namespace limner {

/// What the user may have pictures drawn by.
struct StudioBackend {
    const char* code; ///< as backendNames(): "auto", "gl", "cpu"
    QString name;
};

std::span<const StudioBackend> studioBackends();
/// The user's choice; "auto" where there is none.
QString chosenStudioBackend();
void chooseStudioBackend(const QString& code);
/// Of the user's choice; the processor where no OpenGL works. On the interface's thread.
std::unique_ptr<const Backend> makeStudioBackend();
/// What the backend that was made last is, and why: "OpenGL, NVIDIA RTX A2000", "processor, AVX2 (no graphics device)".
QString studioBackendInForce();

} // namespace limner
