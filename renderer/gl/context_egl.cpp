#include "core/base/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/shared_library.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <vector>

namespace limner::gl {

namespace {

struct EglLibrary {
    SharedLibrary library{"libEGL.so.1", "libEGL.so"};
    decltype(&eglGetProcAddress) find = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglChooseConfig) chooseConfig = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC platformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC deviceString = nullptr;

    EglLibrary() {
        library.require("eglGetProcAddress", find);
        library.require("eglInitialize", initialize);
        library.require("eglBindAPI", bindApi);
        library.require("eglChooseConfig", chooseConfig);
        library.require("eglCreateContext", createContext);
        library.require("eglDestroyContext", destroyContext);
        library.require("eglMakeCurrent", makeCurrent);
        platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(find("eglGetPlatformDisplayEXT"));
        queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(find("eglQueryDevicesEXT"));
        deviceString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(find("eglQueryDeviceStringEXT"));
    }
};

const EglLibrary& egl() {
    static const EglLibrary library;
    return library;
}

/// Graphics devices first, then Mesa without a surface (which a machine without a device has too).
std::vector<EGLDisplay> displays() {
    std::vector<EGLDisplay> found;
    if (egl().platformDisplay == nullptr) {
        return found;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (egl().queryDevices != nullptr && egl().queryDevices(devices.size(), devices.data(), &count) == EGL_TRUE) {
        for (EGLint i = 0; i < count; ++i) {
            const char* extensions =
                egl().deviceString != nullptr ? egl().deviceString(devices[i], EGL_EXTENSIONS) : nullptr;
            const std::string names = extensions != nullptr ? extensions : "";
            if (names.find("EGL_MESA_device_software") == std::string::npos) {
                found.push_back(egl().platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
            }
        }
    }
    found.push_back(egl().platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    return found;
}

class EglContext : public Context {
  public:
    EglContext() {
        for (EGLDisplay display : displays()) {
            if (open(display)) {
                return;
            }
        }
        throw Error(ErrorKind::noOpenGl, {"OpenGL cannot be used", "", "EGL gives no OpenGL 4.1 core context",
                                          "update the graphics driver, or use the backend cpu"});
    }
    ~EglContext() override { egl().destroyContext(display_, context_); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    [[nodiscard]] std::string library() const override { return "egl"; }
    bool makeCurrent() override {
        // Qt, or another context's owner, may have bound OpenGL ES on this thread.
        egl().bindApi(EGL_OPENGL_API);
        return egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }
    void release() override { egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    [[nodiscard]] void* find(const char* function) const override {
        return reinterpret_cast<void*>(egl().find(function));
    }

  private:
    bool open(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || egl().initialize(display, nullptr, nullptr) != EGL_TRUE ||
            egl().bindApi(EGL_OPENGL_API) != EGL_TRUE) {
            return false;
        }
        const std::array<EGLint, 3> any = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint configs = 0;
        if (egl().chooseConfig(display, any.data(), &config, 1, &configs) != EGL_TRUE || configs == 0) {
            config = EGL_NO_CONFIG_KHR;
        }
        const std::array<EGLint, 7> version = {
            EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        EGLContext context = egl().createContext(display, config, EGL_NO_CONTEXT, version.data());
        if (context == EGL_NO_CONTEXT) {
            return false;
        }
        display_ = display;
        context_ = context;
        if (!makeCurrent()) {
            egl().destroyContext(display, context);
            return false;
        }
        return true;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<Context> openEgl() { return std::make_unique<EglContext>(); }

} // namespace limner::gl
