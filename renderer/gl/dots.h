#pragma once

#include "renderer/backend.h"
#include "renderer/gl/device.h"
#include "renderer/gl/scene_textures.h"
#include "renderer/marks/dot_cloud.h"
#include "renderer/marks/ink.h"

#include <optional>
#include <vector>

namespace limner::gl {

/// What a cloud of dots is made from.
struct DotSource {
    std::weak_ptr<const MarkField> field;
    Stipple settings;
    double density = 0;
    [[nodiscard]] bool is(const DotSource& other) const;
};

/// What a device keeps of dots from picture to picture.
struct DotMemory {
    /// Textures that are drawn into, made anew where another size is asked for.
    struct Target {
        std::vector<Texture> textures;
        Framebuffer framebuffer;
        glm::ivec2 size{0};
    };
    Target counts;  ///< of the voxels' dots, and their faces
    Target nearest; ///< depth of matter
    Target canvas;  ///< what dots let through
    Target list;
    Texture stencils;
    Texture coverage;
    VertexArray none; ///< without a vertex
    VertexArray vertices;

    std::shared_ptr<const DotCloud> cloud; ///< and what it was made from
    DotSource source;
    DotSource asked; ///< last
};

/// Whether the dots of a plan are drawn here: those that lie on the volume while it turns, in one ink, unless they are
/// larger than the card's points or the eye is amid the volume. Dots of a still view are laid out evenly on paper,
/// which takes all of them together; several inks lie over one another in the order of their depth.
bool canDrawDots(const ContextFacts& facts, const RenderPlan& plan);

/// A plan's dots on a device, its context being current. `canDrawDots` must hold; device, memory and plan outlive it.
/// What does not depend on the view is put on the card once for a field and settings.
class DotDrawing {
  public:
    DotDrawing(Device& device, DotMemory& memory, const RenderPlan& plan, Task& task);
    /// How much light a tile's dots let through, the top row first; absent where there are more dots than the card
    /// holds, and once after a change of what they are made from: while a setting is being moved it is not worth
    /// putting all of them on the card. Throws Error(cancelled), Error(noOpenGl), Error(noResources).
    std::optional<std::vector<float>> drawTile(const Tile& tile);
    /// The dots that are drawn; none where there are too many.
    std::vector<Dot> list();

  private:
    bool prepare(bool atOnce);
    bool makeCloud(bool atOnce);
    void uploadVoxels();
    void drawNearest();
    void drawCounts();
    Program& program(const char* vertex, const char* fragment);
    void setCounts(Program& program);
    void setView(Program& program, TextureUnits& units);
    void setCandidates(Program& program, TextureUnits& units);
    void drawCandidates();
    void resize(DotMemory::Target& target, glm::ivec2 size, const TextureForm& form, int textures) const;
    [[nodiscard]] glm::ivec2 voxelTexels() const;
    GLuint voxelTexture(const char* part, const std::function<glm::vec4(const MarkVoxel&)>& texel);

    Device& device_;
    const Functions& gl_;
    DotMemory& memory_;
    const RenderPlan& plan_;
    const MarkField& field_;
    const Stipple& stipple_;
    Task& task_;
    MarkView view_;
    InkView ink_;
    MarkDepth::Shape depth_;
    bool hides_;
    std::vector<glm::vec4> cuts_; ///< as seen
    GLuint places_ = 0;           ///< textures of the voxels
    GLuint normals_ = 0;
    GLuint surfaces_ = 0;
};

} // namespace limner::gl
