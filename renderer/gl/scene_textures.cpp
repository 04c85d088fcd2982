#include "renderer/gl/scene_textures.h"

#include "core/base/error.h"

#include <tbb/parallel_for.h>

#include <cstring>

namespace limner::gl {

namespace {

/// How a kind of voxel is kept on the card, and what a texel has to be multiplied by and added to.
struct VoxelForm {
    TextureForm texture;
    int bytes = 2;
    glm::vec2 stored{1, 0};
};

/// Programs that draw on the processor interpolate 8-bit texels coarsely: theirs are made 16 bits.
VoxelForm formOf(VoxelType type, const glm::ivec3& voxels, const ContextFacts& facts) {
    VoxelForm form;
    form.texture.size = voxels;
    switch (type) {
    case VoxelType::uint8:
        form.stored = {255, 0};
        if (!facts.software) {
            form.texture.inside = GL_R8;
            form.texture.type = GL_UNSIGNED_BYTE;
            form.bytes = 1;
        }
        break;
    case VoxelType::int16: form.stored = {65535, -32768}; break;
    case VoxelType::float32:
        form.texture.inside = GL_R32F;
        form.texture.type = GL_FLOAT;
        form.bytes = 4;
        break;
    }
    return form;
}

VoxelForm formOfLabels(const glm::ivec3& voxels) {
    VoxelForm form;
    form.texture = {GL_TEXTURE_3D, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, GL_NEAREST, voxels};
    form.bytes = 1;
    return form;
}

/// A row of a volume as the card keeps it.
void convertRow(const Volume& volume, const std::byte* row, int bytes, std::byte* to, int count) {
    const auto n = static_cast<std::size_t>(count);
    if (volume.type() == VoxelType::int16) {
        for (std::size_t i = 0; i < n; ++i) {
            std::uint16_t voxel = 0;
            std::memcpy(&voxel, row + 2 * i, 2);
            voxel ^= 0x8000U; // from -32768
            std::memcpy(to + 2 * i, &voxel, 2);
        }
    } else if (volume.type() == VoxelType::uint8 && bytes == 2) {
        for (std::size_t i = 0; i < n; ++i) {
            const auto voxel = static_cast<std::uint16_t>(static_cast<unsigned>(row[i]) * 257U);
            std::memcpy(to + 2 * i, &voxel, 2);
        }
    } else {
        std::memcpy(to, row, n * static_cast<std::size_t>(bytes));
    }
}

/// Slice by slice: no second copy of the volume.
void uploadVoxels(const Functions& gl, const Volume& volume, const Page& page, const VoxelForm& form) {
    const glm::ivec3 size = page.voxels;
    const std::size_t rowBytes = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(form.bytes);
    const auto own = static_cast<std::size_t>(bytesPerVoxel(volume.type()));
    std::vector<std::byte> slice(rowBytes * static_cast<std::size_t>(size.y));
    for (int z = 0; z < size.z; ++z) {
        tbb::parallel_for(0, size.y, [&](int y) {
            std::vector<std::byte> row(static_cast<std::size_t>(volume.grid().dims.x) * own);
            volume.copyRow(page.firstVoxel.y + y, page.firstVoxel.z + z, row.data());
            convertRow(volume, row.data() + static_cast<std::size_t>(page.firstVoxel.x) * own, form.bytes,
                       slice.data() + rowBytes * static_cast<std::size_t>(y), size.x);
        });
        gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, size.x, size.y, 1, form.texture.format, form.texture.type,
                         slice.data());
    }
}

Buffer bufferOf(const Functions& gl, const void* data, std::size_t bytes) {
    Buffer buffer(gl);
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer.id());
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return buffer;
}

Texture bufferTexture(const Functions& gl, const Buffer& buffer, GLenum format) {
    Texture texture(gl);
    gl.BindTexture(GL_TEXTURE_BUFFER, texture.id());
    gl.TexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
    return texture;
}

/// Level after level; texels of 15 bits become 16.
void uploadAtlas(const Device& device, const StyleAtlas& atlas, bool levels, Texture& texture) {
    const Functions& gl = device.gl();
    const auto count = levels ? static_cast<int>(atlas.levelStart.size()) : 1;
    device.useSpareUnit();
    texture = Texture(gl);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, count > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, count - 1);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0; level < count; ++level) {
        const int size = atlas.size >> level;
        const std::size_t first = 4 * static_cast<std::size_t>(atlas.levelStart[static_cast<std::size_t>(level)]);
        std::vector<float> texels(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
                                  static_cast<std::size_t>(atlas.slots));
        for (std::size_t i = 0; i < texels.size(); ++i) {
            texels[i] = static_cast<float>(atlas.texels[first + i]) / 32767.0F;
        }
        gl.TexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_RGBA16, size, size, atlas.slots, 0, GL_RGBA, GL_FLOAT,
                      texels.data());
    }
}

void uploadCue(const Device& device, const CueField& cue, Texture& texture) {
    const bool four = cue.channels == 4;
    const TextureForm form{
        GL_TEXTURE_3D, four ? GL_RGBA32F : GL_R32F, four ? GLenum{GL_RGBA} : GLenum{GL_RED}, GL_FLOAT, GL_LINEAR,
        cue.dims};
    texture = device.makeTexture(form);
    device.gl().TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, cue.dims.x, cue.dims.y, cue.dims.z, form.format, form.type,
                              cue.values.data());
}

} // namespace

void TextureUnits::bind(const std::string& uniform, GLenum target, GLuint texture) {
    const auto found = units_.emplace(uniform, static_cast<int>(units_.size())).first;
    if (found->second + 1 >= device_.facts().textureUnits) {
        throw Error(ErrorKind::noOpenGl,
                    {"this figure cannot be drawn with OpenGL", "",
                     "it reads more fields than the card has texture units", "use the backend cpu"});
    }
    device_.gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(found->second));
    device_.gl().BindTexture(target, texture);
    program_.set(uniform, found->second);
}

SceneTextures::SceneTextures(Device& device, const RenderPlan& plan, const KernelScene& scene,
                             const SceneTables& tables)
    : device_(device), plan_(plan), scene_(scene), tables_(tables) {
    const Functions& gl = device.gl();
    if (static_cast<int>(std::max(tables.numbers.size(), tables.colours.size())) > device.facts().largestTable) {
        throw Error(ErrorKind::noOpenGl, {"this figure cannot be drawn with OpenGL", "",
                                          "its tables are larger than the card's", "use the backend cpu"});
    }
    device.useSpareUnit();
    numbers_ = bufferOf(gl, tables.numbers.data(), tables.numbers.size() * sizeof(float));
    colours_ = bufferOf(gl, tables.colours.data(), tables.colours.size() * sizeof(glm::vec4));
    numbersTexture_ = bufferTexture(gl, numbers_, GL_R32F);
    coloursTexture_ = bufferTexture(gl, colours_, GL_RGBA32F);
}

void SceneTextures::bind(TextureUnits& units, Program& program) const {
    units.bind("numbers", GL_TEXTURE_BUFFER, numbersTexture_.id());
    units.bind("colours", GL_TEXTURE_BUFFER, coloursTexture_.id());
    for (const auto& [name, first] : tables_.places) {
        program.set(name, first);
    }
    const auto& skip = plan_.skip;
    units.bind("distances", GL_TEXTURE_3D, device_.texture(skip, "", skip->distance.size(), [&](Texture& texture) {
        const TextureForm form{GL_TEXTURE_3D, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, GL_NEAREST, skip->blocks};
        texture = device_.makeTexture(form);
        device_.gl().TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, skip->blocks.x, skip->blocks.y, skip->blocks.z,
                                   form.format, form.type, skip->distance.data());
    }));
    if (plan_.atlas) {
        const bool levels = plan_.mipLevels.has_value();
        units.bind("styles", GL_TEXTURE_2D_ARRAY,
                   device_.texture(plan_.atlas, levels ? "levels" : "", plan_.atlas->texels.size() * 2,
                                   [&](Texture& texture) { uploadAtlas(device_, *plan_.atlas, levels, texture); }));
    }
    const auto cue = [&](const std::string& name, const std::shared_ptr<const CueField>& field) {
        if (field) {
            units.bind(name, GL_TEXTURE_3D, device_.texture(field, "", field->values.size() * 4, [&](Texture& texture) {
                uploadCue(device_, *field, texture);
            }));
        }
    };
    if (plan_.cues) {
        cue("cueAmbient", plan_.cues->ambient);
        cue("cueShadow", plan_.cues->shadow);
        cue("cueHalo", plan_.cues->halo);
    }
}

void SceneTextures::bindVolume(const std::shared_ptr<const Volume>& volume, const Page& page,
                               const std::string& uniform, TextureUnits& units) const {
    if (!volume) {
        return;
    }
    const VoxelForm form =
        uniform == "labels" ? formOfLabels(page.voxels) : formOf(volume->type(), page.voxels, device_.facts());
    const auto voxels = static_cast<std::uint64_t>(page.voxels.x) * static_cast<std::uint64_t>(page.voxels.y) *
                        static_cast<std::uint64_t>(page.voxels.z);
    units.bind(
        uniform, GL_TEXTURE_3D,
        device_.texture(volume, page.name(), voxels * static_cast<std::uint64_t>(form.bytes), [&](Texture& texture) {
            texture = device_.makeTexture(form.texture);
            uploadVoxels(device_.gl(), *volume, page, form);
        }));
}

void SceneTextures::bindPage(const Page& page, TextureUnits& units, Program& program) const {
    const auto bind = [&](const std::string& uniform, const std::string& stored,
                          const std::shared_ptr<const Volume>& volume, float factor = 1) {
        if (volume) {
            bindVolume(volume, page, uniform, units);
            program.set(stored, formOf(volume->type(), page.voxels, device_.facts()).stored * factor);
        }
    };
    bind("field", "storedField", plan_.field);
    // The march's own reading: table entry = texel * x + y.
    const float unit = kernelScale(plan_.field->type());
    const glm::vec2 stored = formOf(plan_.field->type(), page.voxels, device_.facts()).stored;
    program.set("entryOfTexel",
                glm::vec2(stored.x * scene_.tableScale * unit, stored.y * scene_.tableScale * unit + scene_.tableBias));
    bind("gradientField", "storedGradient",
         plan_.gradient == GradientEstimator::central ? nullptr : plan_.gradientField);
    bind("bendField", "storedBend", plan_.bendField);
    bind("secondVolume", "storedSecond", plan_.secondVolume);
    bindVolume(plan_.labels, page, "labels", units);
    for (std::size_t k = 0; k < plan_.blurs.size(); ++k) {
        bind("blurs[" + std::to_string(k) + "]", "storedBlur", plan_.blurs[k]);
    }
    for (std::size_t i = 0; i < plan_.layers.size(); ++i) {
        bind("distanceField" + std::to_string(i), "storedDistance" + std::to_string(i), plan_.layers[i].distance);
    }
    const auto statistics = [&](const std::optional<PlanImportance>& measures, const std::string& instance) {
        if (measures && measures->statistics) {
            bind("statistics" + instance, "storedStatistics" + instance, measures->statistics,
                 static_cast<float>(measures->source->weights.statistics * measures->statistics->contents().slope));
        }
    };
    statistics(plan_.importance, "0");
    statistics(plan_.axisMeasures, "1");
    program.set("pageFirst", page.firstVoxel);
    program.set("pageSize", glm::vec3(page.voxels));
    const glm::dvec3 size(page.voxels);
    program.set("placeScale", glm::vec3(1.0 / size));
    program.set("placeShift", glm::vec3((-0.5 - glm::dvec3(page.firstVoxel)) / size));
    program.set("pageLow", page.lowCell);
    program.set("pageHigh", page.highCell);
}

} // namespace limner::gl
