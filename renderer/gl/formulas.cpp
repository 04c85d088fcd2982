#include "renderer/gl/formulas.h"

#include "renderer/gl/device.h"

namespace limner::gl {

namespace {

constexpr int kAcross = 256; // sets in a row of the target

ProgramSource formulaProgram(Formula formula) {
    ProgramSource source;
    source.define("FORMULA", static_cast<int>(formula)).define("kAcross", kAcross);
    return source.add("math.glsl").add("formulas.glsl").add("evaluate_formula.frag");
}

} // namespace

std::vector<float> evaluateFormula(const ContextFactory& contexts, Formula formula, std::size_t count,
                                   const std::vector<float>& arguments) {
    Device device(contexts());
    const Functions& gl = device.gl();
    const std::size_t sets = arguments.size() / count;
    const int rows = static_cast<int>((sets + kAcross - 1) / kAcross);
    const Texture target =
        device.makeTexture({GL_TEXTURE_2D, GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, {kAcross, rows, 1}});
    const Framebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
    const VertexArray vertices(gl);
    gl.BindVertexArray(vertices.id());
    const Buffer numbers(gl);
    gl.BindBuffer(GL_TEXTURE_BUFFER, numbers.id());
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(arguments.size() * sizeof(float)), arguments.data(),
                  GL_STATIC_DRAW);
    const Texture table(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_BUFFER, table.id());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_R32F, numbers.id());
    Program& program = device.program(ProgramSource().add("whole_target.vert"), formulaProgram(formula));
    program.use();
    program.set("arguments_", 0);
    program.set("argumentCount", static_cast<int>(count));
    program.set("sets", static_cast<int>(sets));
    gl.Viewport(0, 0, kAcross, rows);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> rgba(4 * static_cast<std::size_t>(kAcross) * static_cast<std::size_t>(rows));
    gl.ReadPixels(0, 0, kAcross, rows, GL_RGBA, GL_FLOAT, rgba.data());
    device.check("to evaluate a formula");
    std::vector<float> results;
    for (std::size_t i = 0; i < sets; ++i) {
        results.insert(results.end(), &rgba[4 * i], &rgba[4 * i] + kindOf(formula).results);
    }
    return results;
}

} // namespace limner::gl
