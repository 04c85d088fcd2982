#include "app/studio/qt_context.h"

#include "core/base/error.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>

namespace limner {
namespace {

QSurfaceFormat wantedFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(4, 1);
    return format;
}

class QtContext : public gl::Context {
  public:
    explicit QtContext(std::shared_ptr<QOffscreenSurface> surface) : surface_(std::move(surface)) {
        context_.setFormat(wantedFormat());
        const bool open = context_.create() && context_.format().version() >= std::make_pair(4, 1) && makeCurrent();
        if (!open) {
            throw Error(ErrorKind::noOpenGl, {"OpenGL cannot be used", "", "Qt gives no OpenGL 4.1 core context",
                                              "update the graphics driver, or draw with the processor"});
        }
    }
    ~QtContext() override { adopt(); }
    QtContext(const QtContext&) = delete;
    QtContext& operator=(const QtContext&) = delete;

    [[nodiscard]] std::string library() const override { return "qt"; }
    bool makeCurrent() override {
        adopt();
        return context_.makeCurrent(surface_.get());
    }
    void release() override {
        context_.doneCurrent();
        context_.moveToThread(nullptr); // what belongs to no thread may be taken by any
    }
    [[nodiscard]] void* find(const char* function) const override {
        return reinterpret_cast<void*>(context_.getProcAddress(function));
    }

  private:
    void adopt() {
        if (context_.thread() == nullptr)
            context_.moveToThread(QThread::currentThread());
    }

    std::shared_ptr<QOffscreenSurface> surface_;
    QOpenGLContext context_;
};

} // namespace

gl::ContextFactory qtContexts() {
    const auto surface = std::make_shared<QOffscreenSurface>();
    surface->setFormat(wantedFormat());
    surface->create();
    return [surface] { return std::make_unique<QtContext>(surface); };
}

} // namespace limner
