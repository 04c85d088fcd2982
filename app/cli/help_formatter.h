#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace limner::cli {

/// Help that fits a terminal of 80 columns: options' texts are wrapped, commands are listed by the first line of
/// their description.
std::shared_ptr<CLI::FormatterBase> makeHelpFormatter();

} // namespace limner::cli
