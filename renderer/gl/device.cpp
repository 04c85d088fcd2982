#include "renderer/gl/device.h"

#include "core/base/error.h"

#include <iterator>

namespace limner::gl {

namespace {

/// Where nothing tells how much memory a card has: what every card of the last ten years has.
constexpr std::uint64_t kUsualRoom = std::uint64_t{1} << 31U;

bool hasExtension(const Functions& gl, const std::string& name) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        if (name == reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)))) {
            return true;
        }
    }
    return false;
}

/// What NVIDIA's and AMD's extensions say is there; 0: unknown.
std::uint64_t memoryOf(const Functions& gl) {
    constexpr GLenum kTotalNvidia = 0x9047; // GPU_MEMORY_INFO_DEDICATED_VIDMEM_NVX
    constexpr GLenum kFreeAmd = 0x87FC;     // TEXTURE_FREE_MEMORY_ATI
    GLint kib[4] = {};
    if (hasExtension(gl, "GL_NVX_gpu_memory_info")) {
        gl.GetIntegerv(kTotalNvidia, kib);
    } else if (hasExtension(gl, "GL_ATI_meminfo")) {
        gl.GetIntegerv(kFreeAmd, kib);
    }
    return static_cast<std::uint64_t>(kib[0]) * 1024;
}

void APIENTRY keepComplaint(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/, GLsizei length,
                            const GLchar* message, const void* complaints) {
    if (type == GL_DEBUG_TYPE_ERROR) {
        auto* kept = static_cast<std::vector<std::string>*>(const_cast<void*>(complaints));
        kept->emplace_back(message,
                           length > 0 ? static_cast<std::size_t>(length) : std::char_traits<char>::length(message));
    }
}

} // namespace

Device::Device(std::unique_ptr<Context> context) : context_(std::move(context)) {
    gl_ = loadFunctions([this](const char* name) { return context_->find(name); });
    facts_ = factsOf(*context_, gl_);
    if (gl_.DebugMessageCallback != nullptr) {
        gl_.Enable(GL_DEBUG_OUTPUT);
        gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        gl_.DebugMessageCallback(keepComplaint, &complaints_);
    }
    const std::uint64_t memory = memoryOf(gl_);
    room_ = memory > 0 ? memory / 4 * 3 : kUsualRoom; // the desktop needs some
}

Device::~Device() {
    gl_.lost = gl_.lost || !context_->makeCurrent();
    programs_.clear();
    residents_.clear();
    context_->release();
}

bool Device::makeCurrent() { return !gl_.lost && context_->makeCurrent(); }

bool Device::isLost() {
    gl_.lost = gl_.lost || (gl_.GetGraphicsResetStatus != nullptr && gl_.GetGraphicsResetStatus() != GL_NO_ERROR);
    return gl_.lost;
}

void Device::lose() { gl_.lost = true; }

Program& Device::program(const ProgramSource& vertex, const ProgramSource& fragment) {
    std::unique_ptr<Program>& made = programs_[vertex.text() + fragment.text()];
    if (!made) {
        made = std::make_unique<Program>(gl_, vertex, fragment);
    }
    return *made;
}

GLuint Device::texture(const std::shared_ptr<const void>& source, const std::string& part, std::uint64_t bytes,
                       const std::function<void(Texture&)>& upload) {
    return resident(source, part, bytes, [&](Resident& made) { upload(made.texture); }).texture.id();
}

GLuint Device::buffer(const std::shared_ptr<const void>& source, const std::string& part, std::uint64_t bytes,
                      const std::function<void(Buffer&)>& upload) {
    return resident(source, part, bytes, [&](Resident& made) { upload(made.buffer); }).buffer.id();
}

Device::Resident& Device::resident(const std::shared_ptr<const void>& source, const std::string& part,
                                   std::uint64_t bytes, const std::function<void(Resident&)>& upload) {
    const Key key{source.get(), part};
    auto found = residents_.find(key);
    if (found != residents_.end() && found->second.source.expired()) { // another thing at the same address
        drop(found);
        found = residents_.end();
    }
    if (found == residents_.end()) {
        makeRoom(bytes);
        Resident made{source, Texture(), Buffer(), bytes, 0};
        upload(made);
        check("to put data on the card");
        used_ += bytes;
        found = residents_.emplace(key, std::move(made)).first;
    }
    found->second.lastUse = ++uses_;
    return found->second;
}

void Device::makeRoom(std::uint64_t bytes) {
    for (auto at = residents_.begin(); at != residents_.end();) {
        const auto next = std::next(at);
        if (at->second.source.expired()) {
            drop(at);
        }
        at = next;
    }
    while (!residents_.empty() && used_ + bytes > room_) {
        auto oldest = residents_.begin();
        for (auto at = residents_.begin(); at != residents_.end(); ++at) {
            oldest = at->second.lastUse < oldest->second.lastUse ? at : oldest;
        }
        drop(oldest);
    }
}

void Device::drop(std::map<Key, Resident>::iterator which) {
    used_ -= which->second.bytes;
    residents_.erase(which);
}

void Device::useSpareUnit() const { gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(facts_.textureUnits) - 1); }

Texture Device::makeTexture(const TextureForm& form) const {
    useSpareUnit();
    Texture texture(gl_);
    gl_.BindTexture(form.target, texture.id());
    gl_.TexParameteri(form.target, GL_TEXTURE_MIN_FILTER, form.filter);
    gl_.TexParameteri(form.target, GL_TEXTURE_MAG_FILTER, form.filter == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        gl_.TexParameteri(form.target, axis, GL_CLAMP_TO_EDGE);
    }
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (form.target == GL_TEXTURE_2D) {
        gl_.TexImage2D(form.target, 0, form.inside, form.size.x, form.size.y, 0, form.format, form.type, nullptr);
    } else {
        gl_.TexImage3D(form.target, 0, form.inside, form.size.x, form.size.y, form.size.z, 0, form.format, form.type,
                       nullptr);
    }
    return texture;
}

void Device::check(const char* doing) const {
    const GLenum error = gl_.GetError();
    if (error == GL_NO_ERROR) {
        return;
    }
    if (error == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::noResources, {std::string("cannot ") + (doing + 3), "", "the card's memory is full",
                                             "render with the backend cpu"});
    }
    const std::string why = complaints_.empty() ? "error " + std::to_string(error) : complaints_.back();
    throw Error(ErrorKind::noOpenGl, {std::string("OpenGL failed ") + doing, "", why, "render with the backend cpu"});
}

} // namespace limner::gl
