#pragma once

#include "core/figure/presets.h"
#include "core/project/project.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace limner::cli {

class Console;

/// The options that say which figure is meant: a file, how to read it, a preset, a theme, a view, a size and settings.
class FigureOptions {
  public:
    /// The file, the options for reading a scan, and its labels.
    void declareInput(CLI::App& app, const std::string& name, const std::string& help, bool required = true);
    /// Preset or sample figure, theme, view and settings.
    void declareLook(CLI::App& app);
    /// Size in pixels or millimetres.
    void declareSize(CLI::App& app);
    /// Threads and memory.
    void declareMachine(CLI::App& app);

    /// Opens the file and applies everything, in this order: preset or sample figure, theme, size, view, settings. Says
    /// what was noticed.
    [[nodiscard]] Document open(Console& console) const;
    /// As `open`, but only reads: no preset is laid over, nothing is changed.
    [[nodiscard]] Document openAsIs(Console& console) const;

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] std::optional<std::uint64_t> memory() const;
    [[nodiscard]] int threads() const { return threads_; }
    /// A size was asked for.
    [[nodiscard]] bool sized() const { return !size_.empty() || widthMm_ || heightMm_ || dpi_; }

  private:
    [[nodiscard]] ImportOptions importOptions() const;
    [[nodiscard]] OpenOptions openOptions() const;
    void applySize(Document& document) const;
    void applyView(Document& document) const;
    void applySettings(Document& document, Console& console) const;

    std::string file_;
    std::string raw_;
    std::string series_;
    std::string labels_;
    bool firstComponent_ = false;
    std::string preset_;
    std::string sample_;
    std::string theme_;
    std::string view_;
    std::vector<std::string> settings_;
    std::string size_;
    std::optional<double> widthMm_;
    std::optional<double> heightMm_;
    std::optional<double> dpi_;
    std::string memory_;
    int threads_ = 0;
};

} // namespace limner::cli
