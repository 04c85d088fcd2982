#pragma once

#include "renderer/gl/device.h"
#include "renderer/gl/scene_tables.h"
#include "renderer/plan/render_plan.h"
#include "renderer/scene/kernel_scene.h"

#include <string>
#include <vector>

namespace limner::gl {

/// A block of cells whose samples one pass takes, and the voxels that they read.
struct Page {
    glm::ivec3 lowCell{0};  ///< first
    glm::ivec3 highCell{0}; ///< one past the last
    glm::ivec3 firstVoxel{0};
    glm::ivec3 voxels{0};
    [[nodiscard]] std::string name() const; ///< of its voxels
};

/// A volume cut so that every block's textures fit the card.
struct PageGrid {
    glm::ivec3 count{1};
    std::vector<Page> pages; ///< x fastest
};

/// The pages of a plan's volume. Throws Error(noResources) where not even a small block fits.
PageGrid pagesOf(const RenderPlan& plan, const Device& device);

/// The pages in an order in which no ray comes to an earlier one after a later one.
std::vector<Page> frontToBack(const PageGrid& grid, const KernelScene& scene);

/// Binds textures to units as they are asked for, and tells the program.
class TextureUnits {
  public:
    TextureUnits(Device& device, Program& program) : device_(device), program_(program) {}
    /// Throws Error(noOpenGl) where the card has no more units.
    void bind(const std::string& uniform, GLenum target, GLuint texture);

  private:
    Device& device_;
    Program& program_;
    std::map<std::string, int> units_;
};

/// What does not depend on the page: tables, styles, skip grid, depth cues. `tables` are put on the card anew.
class SceneTextures {
  public:
    SceneTextures(Device& device, const RenderPlan& plan, const KernelScene& scene, const SceneTables& tables);
    void bind(TextureUnits& units, Program& program) const;
    /// And what does: voxels. Puts them on the card where they are not there.
    void bindPage(const Page& page, TextureUnits& units, Program& program) const;

  private:
    void bindVolume(const std::shared_ptr<const Volume>& volume, const Page& page, const std::string& uniform,
                    TextureUnits& units) const;

    Device& device_;
    const RenderPlan& plan_;
    const KernelScene& scene_;
    const SceneTables& tables_;
    Buffer numbers_;
    Buffer colours_;
    Texture numbersTexture_;
    Texture coloursTexture_;
};

} // namespace limner::gl
