#include "core/base/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/shared_library.h"

#include <GL/osmesa.h>

#include <array>

namespace limner::gl {

namespace {

struct OsmesaLibrary {
    SharedLibrary library{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaGetProcAddress) find = nullptr;

    OsmesaLibrary() {
        library.require("OSMesaCreateContextAttribs", create);
        library.require("OSMesaDestroyContext", destroy);
        library.require("OSMesaMakeCurrent", makeCurrent);
        library.require("OSMesaGetProcAddress", find);
    }
};

const OsmesaLibrary& osmesa() {
    static const OsmesaLibrary library;
    return library;
}

class OsmesaContext : public Context {
  public:
    OsmesaContext() {
        const std::array attributes = {OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_PROFILE,
                                       OSMESA_CORE_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       4,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       1,
                                       0};
        context_ = osmesa().create(attributes.data(), nullptr);
        if (context_ == nullptr || !makeCurrent()) {
            throw Error(ErrorKind::noOpenGl, {"OpenGL cannot be used", "", "OSMesa gives no OpenGL 4.1 core context",
                                              "update Mesa, or use the backend cpu"});
        }
    }
    ~OsmesaContext() override {
        if (context_ != nullptr) {
            osmesa().destroy(context_);
        }
    }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    [[nodiscard]] std::string library() const override { return "osmesa"; }
    bool makeCurrent() override {
        return osmesa().makeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }
    void release() override { osmesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
    [[nodiscard]] void* find(const char* function) const override {
        return reinterpret_cast<void*>(osmesa().find(function));
    }

  private:
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> pixel_{}; // its window, which nobody draws into
};

} // namespace

std::unique_ptr<Context> openOsmesa() { return std::make_unique<OsmesaContext>(); }

} // namespace limner::gl
