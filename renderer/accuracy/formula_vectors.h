#pragma once

#include "renderer/accuracy/formula.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// Arguments of a formula and the results that they must have. Single precision gets the arguments rounded.
struct FormulaVector {
    Formula formula;
    std::vector<double> in;
    std::vector<double> out; ///< what is not finite is not known and not compared
    std::string source;      ///< where it stands: "line 12", "numerics.md 2a"
    double rounding = 0;     ///< how far `out` may be from the true results, as it is printed
};

/// What evaluates: the double templates, single precision with one instruction set, or GLSL in one library's context.
struct FormulaEngine {
    std::string backend; ///< "reference", "cpu" or "gl", as Backend::name()
    std::string target;  ///< "double", as kernelTargets(), or as gl::contextLibraries()
};

/// How a formula did on all its vectors.
struct FormulaReport {
    std::string formula;
    int count = 0;
    double largestAbsolute = 0;
    double largestRelative = 0; ///< over the results that are not 0
    std::string worst;          ///< source of the vector that is nearest to its bound, or furthest over it
    bool passed = true;
    std::string bound; ///< what was asked, with the reason where it is not the usual bound
};

/// The reference, the SIMD backend with every instruction set of this machine, and OpenGL with every library whose
/// context opens; or only those of one backend.
std::vector<FormulaEngine> formulaEngines(const std::string& backend = "");

/// The lines of a file of test vectors (spec vectors/README.md). Throws Error(badInput) with the number of the first
/// line that is none: no JSON, unknown formula, wrong count, an argument that is no float32 value.
std::vector<FormulaVector> readFormulaVectors(const std::filesystem::path& path);

/// The values that the specification prints (numerics.md 2a to 2e, accuracy.md A5).
std::vector<FormulaVector> publishedFormulaValues();

/// Results in the order of the vectors, each as long as `out`. Not while pictures are rendered: the SIMD
/// backend's instruction set is chosen for the whole program.
std::vector<std::vector<double>> evaluateFormulas(const FormulaEngine& engine,
                                                  const std::vector<FormulaVector>& vectors);

/// One report for each formula that occurs, in the enumeration's order. Bounds: 1e-12 relative in double, 2e-6 of the
/// result's natural range in single precision. As `evaluateFormulas`.
std::vector<FormulaReport> checkFormulas(const std::vector<FormulaVector>& vectors, const FormulaEngine& engine);

} // namespace limner
