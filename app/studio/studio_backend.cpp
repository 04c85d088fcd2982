#include "app/studio/studio_backend.h"

#include "app/studio/qt_context.h"

#include "core/base/error.h"
#include "renderer/backend_choice.h"
#include "renderer/gl/gl_backend.h"

#include <QCoreApplication>
#include <QSettings>

namespace limner {
namespace {

constexpr auto kSetting = "render/backend";

/// Words for the backend that was made last: to open a context for the asking takes too long for a window.
QString& inForce() {
    static QString words;
    return words;
}

/// Where OpenGL is asked for and no library of its own gives a context, Qt may.
std::unique_ptr<const Backend> makeChosen() {
    const std::string chosen = chosenStudioBackend().toStdString();
    try {
        return makeBackend(chosen);
    } catch (const Error&) {
        return makeGlBackend(qtContexts());
    }
}

} // namespace

std::span<const StudioBackend> studioBackends() {
    static const StudioBackend kBackends[] = {
        {"auto", QCoreApplication::translate("StudioBackend", "Graphics card where there is one")},
        {"gl", QCoreApplication::translate("StudioBackend", "OpenGL")},
        {"cpu", QCoreApplication::translate("StudioBackend", "Processor")}};
    return kBackends;
}

QString chosenStudioBackend() {
    const QString chosen = QSettings().value(kSetting).toString();
    for (const StudioBackend& backend : studioBackends()) {
        if (chosen == backend.code)
            return chosen;
    }
    return "auto";
}

void chooseStudioBackend(const QString& code) { QSettings().setValue(kSetting, code); }

std::unique_ptr<const Backend> makeStudioBackend() {
    std::unique_ptr<const Backend> backend;
    QString why;
    try {
        backend = makeChosen();
        if (chosenStudioBackend() == "auto" && backend->name() == "cpu")
            why = QString::fromStdString(automaticBackend().reason);
    } catch (const Error& error) {
        backend = makeCpuBackend();
        why = QString::fromStdString(error.text().why);
    }
    const QString detail = QString::fromStdString(backendDetail(*backend));
    if (backend->name() == "gl")
        inForce() = QCoreApplication::translate("StudioBackend", "OpenGL, %1").arg(detail);
    else if (why.isEmpty())
        inForce() = QCoreApplication::translate("StudioBackend", "processor, %1").arg(detail);
    else
        inForce() = QCoreApplication::translate("StudioBackend", "processor, %1 (%2)").arg(detail, why);
    return backend;
}

QString studioBackendInForce() { return inForce(); }

} // namespace limner
