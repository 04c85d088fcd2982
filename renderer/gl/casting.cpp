#include "renderer/gl/casting.h"

#include "renderer/gl/scene_program.h"
#include "renderer/gl/scene_textures.h"
#include "renderer/gl/scene_uniforms.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/scene/scene_builder.h"
#include "renderer/scene/sub_pixels.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>

namespace limner::gl {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// A block of kTile sub-pixels squared of the whole picture, and what of it is wanted.
struct Block {
    glm::ivec2 corner;
    glm::ivec2 low; ///< wanted, from the corner
    glm::ivec2 high;
};

std::vector<Block> blocksOf(const Tile& tile, int subPixels) {
    const glm::ivec2 first = tile.origin * subPixels;
    const glm::ivec2 end = (tile.origin + tile.size) * subPixels;
    std::vector<Block> blocks;
    for (int y = first.y / kTile * kTile; y < end.y; y += kTile) {
        for (int x = first.x / kTile * kTile; x < end.x; x += kTile) {
            const glm::ivec2 corner(x, y);
            blocks.push_back(
                {corner, glm::max(first - corner, glm::ivec2(0)), glm::min(end - corner, glm::ivec2(kTile))});
        }
    }
    return blocks;
}

/// Samples of a ray in one pass: llvmpipe ends all loops of a ray after 65,535 rounds together, of which a sample that
/// shows takes about ten; and a driver's watchdog ends a long draw.
constexpr int kMostSamples = 4096;

/// How many passes the longest ray through a plan's volume takes.
int stretchesOf(const RenderPlan& plan) {
    const glm::dvec3 box = plan.volume->grid().voxelToMmMatrix() * glm::dvec3(plan.volume->grid().dims);
    const glm::dmat3 axes = plan.volume->grid().voxelToMmMatrix();
    double longest = glm::length(box); // of the box's four diagonals
    for (int axis = 0; axis < 3; ++axis) {
        longest = std::max(longest, glm::length(box - 2.0 * axes[axis] * double(plan.volume->grid().dims[axis])));
    }
    return 1 + static_cast<int>(longest / plan.lattice.stepMm / kMostSamples);
}

constexpr int kCountBlock = 16; ///< edge of the blocks whose counts a sum takes: 2^24 samples and more are exact

class Casting {
    using Target = CastingMemory::Target;

  public:
    Casting(Device& device, CastingMemory& memory, const RenderPlan& plan, Task& task)
        : device_(device), gl_(device.gl()), memory_(memory), plan_(plan), task_(task), built_(plan),
          tables_(sceneTables(plan, built_.scene())), textures_(device, plan, built_.scene(), tables_),
          grid_(pagesOf(plan, device)), stretches_(stretchesOf(plan)),
          passes_(stretches_ * static_cast<int>(grid_.pages.size())) {}

    RenderResult run(const Tile& tile) {
        begin();
        RenderResult result{Picture(tile.size), 0, 0};
        const std::vector<Block> blocks = blocksOf(tile, plan_.subPixels);
        if (memory_.loop < 0) {
            chooseLoop(blocks[blocks.size() / 2]);
        }
        if (passes_ == 1) {
            for (const Block& block : blocks) {
                useProgram(memory_.loop == 1, importanceReaches(block), false);
                textures_.bindPage(grid_.pages.front(), *units_, *program_);
                Target& target = targetAt(0);
                clear(target);
                draw(block, target);
                take(block, target, tile, result);
            }
        } else {
            drawPasses(blocks);
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                take(blocks[i], targetAt(i + 1), tile, result);
            }
        }
        device_.check("to draw");
        return result;
    }

  private:
    void begin() {
        if (!memory_.vertices) {
            memory_.vertices = VertexArray(gl_);
        }
        gl_.BindVertexArray(memory_.vertices.id());
        gl_.Disable(GL_BLEND);
        gl_.Disable(GL_DEPTH_TEST);
        gl_.Viewport(0, 0, kTile, kTile);
    }

    /// `passes`: whether the rays' state comes from a pass before.
    void useProgram(bool marchThenShade, bool byImportance, bool passes) {
        const bool lenses = byImportance && !plan_.importance->lenses.empty();
        const ProgramChoices choices{passes, byImportance, marchThenShade, lenses};
        program_ = &device_.program(wholeTarget(), castingProgram(plan_, built_.scene(), choices));
        program_->use();
        units_.emplace(device_, *program_);
        setScene(*program_, plan_, built_.scene());
        textures_.bind(*units_, *program_);
    }

    /// Draws a piece of the picture with both loops, once for a device: which of them is faster depends on whether it
    /// runs both sides of a branch. Each has drawn once before, so that nothing is compiled while the clock runs.
    void chooseLoop(const Block& block) {
        std::array<double, 2> seconds{};
        for (const int loop : {0, 1}) {
            useProgram(loop == 1, plan_.importance.has_value(), false);
            textures_.bindPage(grid_.pages.front(), *units_, *program_);
            Block piece = block;
            piece.low = (block.low + block.high) / 2 - glm::min((block.high - block.low) / 2, glm::ivec2(32));
            piece.high = glm::min(piece.low + 64, block.high);
            for (int round = 0; round < 2; ++round) {
                Target& target = targetAt(0);
                clear(target);
                const auto start = Clock::now();
                draw(piece, target);
                seconds[static_cast<std::size_t>(loop)] = secondsSince(start);
            }
        }
        memory_.loop = seconds[1] < seconds[0] ? 1 : 0;
    }

    /// Where no lens reaches composition is the ordinary one. By blocks: the picture must not depend on the tiling.
    [[nodiscard]] bool importanceReaches(const Block& block) const {
        if (!plan_.importance) {
            return false;
        }
        const double perFigure = 1.0 / plan_.subPixels / plan_.size.y;
        return plan_.kept.has(LeaveOut::importanceOutsideLenses) ||
               !lensesMiss(plan_.importance->lenses, glm::dvec2(block.corner) * perFigure, endOf(block) * perFigure);
    }

    /// Of the picture's part in a block, whatever of it is wanted, in sub-pixels.
    [[nodiscard]] glm::dvec2 endOf(const Block& block) const {
        return glm::min(block.corner + kTile, plan_.size * plan_.subPixels);
    }

    Target& targetAt(std::size_t index) {
        while (memory_.targets.size() <= index) {
            memory_.targets.push_back(makeTarget());
        }
        return memory_.targets[index];
    }

    Target makeTarget() {
        const TextureForm form{GL_TEXTURE_2D, GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, {kTile, kTile, 1}};
        Target target{device_.makeTexture(form), device_.makeTexture(form), Framebuffer(gl_)};
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colours.id(), 0);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, target.state.id(), 0);
        constexpr std::array<GLenum, 2> kBoth = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        gl_.DrawBuffers(2, kBoth.data());
        device_.check("to make a picture to draw into");
        return target;
    }

    void clear(const Target& target) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        gl_.Disable(GL_SCISSOR_TEST);
        constexpr std::array<float, 4> kClear = {0, 0, 0, 0};
        constexpr std::array<float, 4> kBegin = {1, 0, 0, 0}; // as beginPixel() of compose.glsl
        gl_.ClearBufferfv(GL_COLOR, 0, kClear.data());
        gl_.ClearBufferfv(GL_COLOR, 1, kBegin.data());
    }

    /// In slices, each finished before the next: no desktop hangs, no driver's watchdog bites, and a cancelled picture
    /// ends soon. Their size follows the time they take.
    void draw(const Block& block, const Target& target) {
        setBlock(block);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        gl_.Enable(GL_SCISSOR_TEST);
        for (int y = block.low.y; y < block.high.y;) {
            const int height = std::min(memory_.slice, block.high.y - y);
            for (int x = block.low.x; x < block.high.x;) {
                const int width = std::min(memory_.slice, block.high.x - x);
                task_.throwIfCancelled();
                const auto start = Clock::now();
                gl_.Scissor(x, y, width, height);
                gl_.DrawArrays(GL_TRIANGLES, 0, 3);
                gl_.Finish();
                const bool whole = width == memory_.slice && height == memory_.slice;
                x += width;
                if (whole && x >= block.high.x) { // a row of slices has one height
                    pace(secondsSince(start));
                }
            }
            y += height;
        }
    }

    void pace(double seconds) {
        // A display's two frames; where the processor draws there is no display to wait, only the task.
        const double longest = device_.facts().software ? 0.1 : 0.03;
        constexpr int kSmallest = 128; // llvmpipe gives a thread 64 x 64 pixels at a time
        if (seconds > longest) {
            memory_.slice = std::max(memory_.slice / 2, kSmallest);
        } else if (seconds < longest / 4) {
            memory_.slice = std::min(memory_.slice * 2, kTile);
        }
    }

    void setBlock(const Block& block) {
        setTile(*program_, built_.scene(), block.corner);
        if (!built_.ahead()) {
            return;
        }
        // Where a ray ends must not depend on the tiling: bounds are the whole block's.
        const double perPixel = 1.0 / plan_.subPixels;
        const glm::dvec2 low = glm::dvec2(block.corner) * perPixel;
        const glm::dvec2 high = endOf(block) * perPixel;
        program_->set("ahead", std::span<const float>(built_.ahead()->behind(low, high)));
        if (!plan_.importance->lenses.empty()) {
            setWeights(block);
        }
    }

    /// Global weights of a block's sub-pixels, the lenses counted.
    void setWeights(const Block& block) {
        std::vector<float> weights(static_cast<std::size_t>(kTile) * kTile);
        tbb::parallel_for(block.low.y, block.high.y, [&](int y) {
            for (int x = block.low.x; x < block.high.x; ++x) {
                const glm::dvec2 place = (glm::dvec2(block.corner) + glm::dvec2(x, y) + 0.5) / double(plan_.subPixels);
                weights[static_cast<std::size_t>(y) * kTile + static_cast<std::size_t>(x)] =
                    static_cast<float>(globalWeightAt(plan_, place));
            }
        });
        const TextureForm form{GL_TEXTURE_2D, GL_R32F, GL_RED, GL_FLOAT, GL_NEAREST, {kTile, kTile, 1}};
        weights_ = device_.makeTexture(form);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, form.inside, kTile, kTile, 0, form.format, form.type, weights.data());
        units_->bind("weights", GL_TEXTURE_2D, weights_.id());
    }

    /// A volume in parts, or very long rays in stretches: all blocks of a part before the next, the state of the rays
    /// passed on. Target 0 is the one that is drawn into while a block's own is read.
    void drawPasses(const std::vector<Block>& blocks) {
        useProgram(memory_.loop == 1, plan_.importance.has_value(), true);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            clear(targetAt(i + 1));
        }
        int pass = 0;
        for (const Page& page : frontToBack(grid_, built_.scene())) {
            textures_.bind(*units_, *program_); // what all pages read is used anew, so that no page takes its room
            textures_.bindPage(page, *units_, *program_);
            for (int stretch = 0; stretch < stretches_; ++stretch) {
                program_->set("stretch", glm::vec2(stretch, stretch + 1) * float(kMostSamples));
                program_->set("lastPass", ++pass == passes_ ? 1 : 0);
                passOver(blocks);
            }
        }
    }

    void passOver(const std::vector<Block>& blocks) {
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            units_->bind("picturePassed", GL_TEXTURE_2D, targetAt(i + 1).colours.id());
            units_->bind("rayStatePassed", GL_TEXTURE_2D, targetAt(i + 1).state.id());
            clear(targetAt(0));
            draw(blocks[i], targetAt(0));
            std::swap(targetAt(0), targetAt(i + 1));
        }
    }

    void take(const Block& block, const Target& target, const Tile& tile, RenderResult& result) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        const glm::ivec2 size = block.high - block.low;
        std::vector<float> rgba(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl_.ReadPixels(block.low.x, block.low.y, size.x, size.y, GL_RGBA, GL_FLOAT, rgba.data());
        const SubPixels rays{rgba.data(), size.x, block.corner + block.low, size / plan_.subPixels, plan_.subPixels};
        averageSubPixels(rays, tile, result.picture);
        count(target, result);
    }

    /// Summed on the card: a few hundred numbers come back instead of all of the state.
    void count(const Target& target, RenderResult& result) {
        constexpr int kSums = kTile / kCountBlock;
        if (!memory_.sums.framebuffer) {
            memory_.sums = makeSums(kSums);
        }
        ProgramSource source;
        source.define("kBlock", kCountBlock).add("sum_counts.frag");
        Program& program = device_.program(wholeTarget(), source);
        program.use();
        device_.useSpareUnit();
        gl_.BindTexture(GL_TEXTURE_2D, target.state.id());
        program.set("rayState", device_.facts().textureUnits - 1);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, memory_.sums.framebuffer.id());
        gl_.Disable(GL_SCISSOR_TEST);
        gl_.Viewport(0, 0, kSums, kSums);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<float> sums(4 * std::size_t{kSums} * kSums);
        gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl_.ReadPixels(0, 0, kSums, kSums, GL_RGBA, GL_FLOAT, sums.data());
        for (std::size_t i = 0; i < sums.size(); i += 4) {
            result.samples += static_cast<std::uint64_t>(sums[i]);
            result.shaded += static_cast<std::uint64_t>(sums[i + 1]);
        }
        gl_.Viewport(0, 0, kTile, kTile);
        program_->use();
    }

    Target makeSums(int edge) {
        const TextureForm form{GL_TEXTURE_2D, GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, {edge, edge, 1}};
        Target target{device_.makeTexture(form), Texture(), Framebuffer(gl_)};
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colours.id(), 0);
        return target;
    }

    Device& device_;
    const Functions& gl_;
    CastingMemory& memory_;
    const RenderPlan& plan_;
    Task& task_;
    BuiltScene built_;
    SceneTables tables_;
    SceneTextures textures_;
    PageGrid grid_;
    int stretches_; ///< of a ray
    int passes_;
    Program* program_ = nullptr;
    std::optional<TextureUnits> units_;
    Texture weights_;
};

} // namespace

RenderResult castTile(Device& device, CastingMemory& memory, const RenderPlan& plan, const Tile& tile, Task& task) {
    if (plan.layers.empty() || tile.size.x <= 0 || tile.size.y <= 0) {
        return {Picture(tile.size), 0, 0};
    }
    return Casting(device, memory, plan, task).run(tile);
}

} // namespace limner::gl
