#pragma once

#include "renderer/backend.h"

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace limner::cli {

/// What draws: `--backend` and `--gl`.
class BackendOptions {
  public:
    void declare(CLI::App& app);
    /// Throws Error(usage) and Error(noOpenGl).
    [[nodiscard]] std::unique_ptr<Backend> make() const;
    /// As it was asked for: "auto", "cpu", ...
    [[nodiscard]] const std::string& name() const { return backend_; }

  private:
    std::string backend_ = "auto";
    std::string library_ = "auto";
};

} // namespace limner::cli
