#include "renderer/gl/scene_tables.h"

#include <algorithm>
#include <utility>

namespace limner::gl {

namespace {

class Tables {
  public:
    explicit Tables(SceneTables& out) : out_(out) {}

    template <typename Number>
    void addNumbers(const std::string& name, const Number* from, std::size_t count) {
        if (from == nullptr) {
            return;
        }
        place(name, out_.numbers.size());
        for (std::size_t i = 0; i < count; ++i) {
            out_.numbers.push_back(static_cast<float>(from[i]));
        }
    }
    /// `from`: four floats for each.
    void addColours(const std::string& name, const float* from, std::size_t count) {
        if (from == nullptr) {
            return;
        }
        place(name, out_.colours.size());
        for (std::size_t i = 0; i < count; ++i) {
            out_.colours.emplace_back(from[4 * i], from[4 * i + 1], from[4 * i + 2], from[4 * i + 3]);
        }
    }
    void addCut(const std::string& name, const KernelCut& cut) {
        place(name, out_.colours.size());
        for (int i = 0; i < cut.count; ++i) {
            const KernelCut::Plane& p = cut.planes[i];
            out_.colours.emplace_back(p.insideFromCell[0], p.insideFromCell[1], p.insideFromCell[2],
                                      p.insideFromCell[3]);
            out_.colours.emplace_back(p.normalEye[0], p.normalEye[1], p.normalEye[2], 0.0F);
            out_.colours.emplace_back(p.rgb[0], p.rgb[1], p.rgb[2], 0.0F);
        }
    }
    /// A node's texture: where its tile begins among the colours (-1: none), size, tiles per mm, strength.
    void addTextures(const std::string& name, const KernelTexture* textures, std::size_t count) {
        std::vector<float> nodes;
        for (std::size_t i = 0; i < count; ++i) {
            const KernelTexture& texture = textures[i];
            nodes.insert(nodes.end(), {-1.0F, static_cast<float>(texture.size), texture.perMm, texture.strength});
            if (texture.texels != nullptr) {
                nodes[4 * i] = static_cast<float>(firstOf(texture));
            }
        }
        addNumbers(name, nodes.data(), nodes.size());
    }

  private:
    void place(const std::string& name, std::size_t first) { out_.places.emplace_back(name, static_cast<int>(first)); }

    /// Nodes share tiles.
    std::size_t firstOf(const KernelTexture& texture) {
        const auto found =
            std::find_if(tiles_.begin(), tiles_.end(), [&](const auto& tile) { return tile.first == texture.texels; });
        if (found != tiles_.end()) {
            return found->second;
        }
        const std::size_t first = out_.colours.size();
        tiles_.emplace_back(texture.texels, first);
        const auto texels = static_cast<std::size_t>(texture.size) * static_cast<std::size_t>(texture.size);
        for (std::size_t i = 0; i < texels; ++i) {
            const float* t = texture.texels + 4 * i;
            out_.colours.emplace_back(t[0], t[1], t[2], t[3]);
        }
        return first;
    }

    SceneTables& out_;
    std::vector<std::pair<const float*, std::size_t>> tiles_;
};

void addLayer(Tables& tables, const PlanLayer& plan, const KernelLayer& layer, const std::string& number) {
    const std::size_t entries = static_cast<std::size_t>(layer.x.last) + 2; // one more than there are
    const auto rows = static_cast<std::size_t>(layer.rows);
    const std::size_t nodes = plan.styles.nodeToStyle.size();
    tables.addNumbers("stepOpacity" + number, layer.stepOpacity, entries);
    tables.addNumbers("slabTable" + number, layer.slabs, plan.slabs.size());
    if (rows > 0) {
        tables.addNumbers("opacity" + number, layer.opacity2d, rows * static_cast<std::size_t>(layer.rowStride) + 1);
        tables.addNumbers("rowIndex" + number, layer.rowIndex, rows + 1);
    } else {
        tables.addNumbers("opacity" + number, layer.opacity, entries);
    }
    tables.addNumbers("indexTable" + number, layer.index, entries);
    tables.addNumbers("nodeSlots" + number, layer.slotOfNode, layer.slotOfNode != nullptr ? nodes : 0);
    tables.addNumbers("slotRows" + number, layer.rowOfSlot, plan.rowOfSlot.size());
    tables.addNumbers("slotShown" + number, layer.shownSlots, plan.shownSlots.size());
    tables.addColours("entryColours" + number, layer.colours, entries);
    tables.addColours("nodeColours" + number, layer.nodeColours, nodes);
    if (layer.textures != nullptr) {
        tables.addTextures("nodeTextures" + number, layer.textures, nodes);
    }
    const KernelParts& parts = layer.parts;
    const std::size_t ramp = static_cast<std::size_t>(parts.lastEntry) + 2;
    tables.addColours("toneTable" + number, parts.tone, ramp);
    tables.addColours("positionTable" + number, parts.position, ramp);
    tables.addNumbers("gradientOpacity" + number, parts.gradientOpacity, ramp);
    tables.addNumbers("lineOpacity" + number, parts.lineOpacity, ramp);
    if (layer.cut != nullptr) {
        tables.addCut("cutTable" + number, *layer.cut);
    }
}

} // namespace

SceneTables sceneTables(const RenderPlan& plan, const KernelScene& scene) {
    SceneTables out;
    Tables tables(out);
    std::vector<float> visibility(scene.visibility, scene.visibility + static_cast<std::size_t>(scene.lastEntry) + 2);
    for (std::size_t i = 0; i + 1 < visibility.size(); ++i) {
        visibility[i] = std::max(visibility[i], visibility[i + 1]); // of the interval behind the entry: one read tells
    }
    if (scene.preintegrated) { // slabs ask whether anything shows between two entries
        float before = 0;
        for (float& interval : visibility) {
            before += std::exchange(interval, before) > 0 ? 1.0F : 0.0F;
        }
    }
    tables.addNumbers("visibility", visibility.data(), visibility.size());
    for (std::size_t i = 0; i < plan.layers.size(); ++i) {
        addLayer(tables, plan.layers[i], scene.layers[i], std::to_string(i));
    }
    if (plan.atlas) {
        tables.addColours("styleMeans", scene.atlas.mean, plan.atlas->mean.size());
    }
    if (plan.importance) {
        tables.addNumbers("objectTable0", scene.importance.weightOfSlot, plan.importance->weightOfSlot.size());
    }
    if (plan.axisMeasures) {
        tables.addNumbers("objectTable1", scene.axisImportance.weightOfSlot, plan.axisMeasures->weightOfSlot.size());
    }
    if (scene.faces != nullptr) {
        tables.addCut("faceTable", *scene.faces);
    }
    std::vector<float> planes;
    for (int i = 0; i < scene.planeCount; ++i) {
        const KernelPlane& p = scene.planes[i];
        for (const double number : {p.normal[0], p.normal[1], p.normal[2], p.offset}) {
            planes.push_back(static_cast<float>(number));
        }
    }
    tables.addColours("clipPlaneTable", planes.data(), planes.size() / 4);
    // A buffer must not be empty.
    out.numbers.push_back(0);
    out.colours.emplace_back(0);
    return out;
}

} // namespace limner::gl
