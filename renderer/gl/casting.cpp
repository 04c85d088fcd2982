#include "renderer/gl/casting.h"

#include "renderer/gl/scene_program.h"
#include "renderer/gl/scene_textures.h"
#include "renderer/gl/scene_uniforms.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/scene/scene_builder.h"
#include "renderer/scene/sub_pixels.h"

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

constexpr int kCountBlock = 16; ///< edge of the blocks whose counts a sum takes: 2^24 samples and more are exact

class Casting {
    using Target = CastingMemory::Target;

  public:
    Casting(Device& device, CastingMemory& memory, const RenderPlan& plan, Task& task)
        : device_(device), gl_(device.gl()), memory_(memory), plan_(plan), task_(task), built_(plan),
          tables_(sceneTables(plan, built_.scene())), textures_(device, plan, built_.scene(), tables_),
          grid_(pagesOf(plan, device)) {}

    RenderResult run(const Tile& tile) {
        begin();
        RenderResult result{Picture(tile.size), 0, 0};
        const std::vector<Block> blocks = blocksOf(tile, plan_.subPixels);
        useProgram(memory_.loop != 0);
        if (memory_.loop < 0) {
            chooseLoop(blocks[blocks.size() / 2]);
        }
        const std::vector<Page> pages = frontToBack(grid_, built_.scene());
        if (pages.size() == 1) {
            textures_.bindPage(pages.front(), *units_, *program_);
            for (const Block& block : blocks) {
                Target& target = targetAt(0);
                clear(target);
                draw(block, target);
                take(block, target, tile, result);
            }
        } else {
            drawPages(pages, blocks);
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

    void useProgram(bool marchThenShade) {
        const bool lenses = plan_.importance && !plan_.importance->lenses.empty();
        const ProgramChoices choices{grid_.pages.size() > 1, marchThenShade, lenses};
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
            useProgram(loop == 1);
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
        useProgram(memory_.loop == 1);
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
        const double perPixel = 1.0 / plan_.subPixels;
        // Of the whole block, whatever of it is wanted: where a ray ends must not depend on the tiling.
        const glm::dvec2 low = glm::dvec2(block.corner) * perPixel;
        const glm::dvec2 high = glm::dvec2(block.corner + kTile) * perPixel;
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

    /// A volume in parts: all blocks of a page before the next page, the state of the rays passed on. Target 0 is the
    /// one that is drawn into while a block's own is read.
    void drawPages(const std::vector<Page>& pages, const std::vector<Block>& blocks) {
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            clear(targetAt(i + 1));
        }
        for (std::size_t p = 0; p < pages.size(); ++p) {
            textures_.bind(*units_, *program_); // what all pages read is used anew, so that no page takes its room
            textures_.bindPage(pages[p], *units_, *program_);
            program_->set("lastPass", p + 1 == pages.size() ? 1 : 0);
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                units_->bind("picturePassed", GL_TEXTURE_2D, targetAt(i + 1).colours.id());
                units_->bind("rayStatePassed", GL_TEXTURE_2D, targetAt(i + 1).state.id());
                clear(targetAt(0));
                draw(blocks[i], targetAt(0));
                std::swap(targetAt(0), targetAt(i + 1));
            }
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
