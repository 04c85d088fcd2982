#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace limner::gl {

struct Functions;

/// A context of OpenGL 4.1 core without a window, made by whichever library there is. Made, used and destroyed by one
/// thread at a time; between two uses it may change threads.
class Context {
  public:
    virtual ~Context() = default;
    /// "egl", "osmesa" or "qt".
    [[nodiscard]] virtual std::string library() const = 0;
    /// False: the context is lost for good.
    virtual bool makeCurrent() = 0;
    /// Current nowhere, so that another thread can take it.
    virtual void release() = 0;
    [[nodiscard]] virtual void* find(const char* function) const = 0;
};

/// What a context draws with.
struct ContextFacts {
    std::string library; ///< Context::library
    std::string vendor;
    std::string renderer; ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;  ///< "4.5 (Core Profile) Mesa 22.3.6"
    std::string glsl;
    int largest3d = 0;     ///< voxels along an edge of a 3D texture
    int largest2d = 0;     ///< pixels
    int largestTable = 0;  ///< entries of a buffer texture
    int textureUnits = 0;  ///< of a fragment shader
    int largestPoint = 0;  ///< pixels
    bool software = false; ///< drawn by the processor: llvmpipe, softpipe, swrast
};

/// Of the current context.
ContextFacts factsOf(const Context& context, const Functions& gl);

/// Whether a renderer's name is that of a program that draws on the processor.
bool isSoftware(const std::string& renderer);

/// Makes contexts, anew after a loss. Throws Error(noOpenGl) with the reason.
using ContextFactory = std::function<std::unique_ptr<Context>()>;

/// `library`: "egl" (a graphics device, else surfaceless), "osmesa" (Mesa on the processor), or "auto": the first of
/// these that works. Throws Error(usage) for another name. The libraries are opened at run time: Limner starts where
/// neither is installed, and OSMesa's functions never stand in for those that Qt calls.
ContextFactory contextFactory(const std::string& library);

/// Names that `contextFactory` knows, "auto" first.
const std::vector<std::string>& contextLibraries();

/// Those but "auto" whose context opens on this machine. Tried once for a program.
const std::vector<std::string>& openLibraries();

/// Whether the system shows any graphics device: where it shows none, OpenGL is drawn by the processor. True where the
/// system does not tell.
bool hasGraphicsDevice();

/// Opens a context, asks what it is, and closes it. Throws Error(noOpenGl).
ContextFacts probe(const ContextFactory& contexts);

std::unique_ptr<Context> openEgl();
std::unique_ptr<Context> openOsmesa();

} // namespace limner::gl
