#pragma once

#include "renderer/backend.h"
#include "renderer/gl/context.h"
#include "renderer/marks/marks.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// The backend on a graphics card, and what only its owner and tests ask of it. `render` may be called from any thread,
/// one call waits for another. A lost context is made anew, and the picture drawn again. Destroyed by a thread on which
/// the context can be made current.
class GlBackend : public Backend {
  public:
    [[nodiscard]] virtual gl::ContextFacts facts() const = 0;
    /// Takes the context away, as a driver's reset does; the next picture makes a new one.
    virtual void loseContext() = 0;
    /// What the driver has complained of so far, its own words.
    [[nodiscard]] virtual std::vector<std::string> complaints() const = 0;
    /// Bytes that textures may take on the card, instead of what the card seems to have; volumes beyond come in parts.
    virtual void setRoom(std::uint64_t bytes) = 0;
    /// The dots that `layDots` lays, in no order, their colour left out.
    [[nodiscard]] virtual std::vector<Dot> dotsOf(const RenderPlan& plan, Task& task) const = 0;
};

/// Opens the first context at once. Throws Error(noOpenGl) where none opens.
std::unique_ptr<GlBackend> makeGlBackend(gl::ContextFactory contexts);

} // namespace limner
