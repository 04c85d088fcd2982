#pragma once

#include <stdexcept>
#include <string>

namespace limner {

/// What kind of failure an Error reports. The values are the command line's exit codes.
enum class ErrorKind {
    usage = 2,          ///< the request itself makes no sense
    badInput = 3,       ///< a file cannot be read as what it claims to be
    noOpenGl = 4,       ///< no usable OpenGL context
    noResources = 5,    ///< out of memory or disk, or over the given budget
    notToTolerance = 6, ///< finished, but not to the asked tolerance
    notConverged = 7,   ///< the accuracy reference did not converge
    notFinite = 8,      ///< non-finite pixels found
    orderFailed = 9,    ///< a convergence order or a formula failed
    cancelled = 130,    ///< the user stopped it
};

/// The parts of a message for people: one line, made of what happened, where, why, and what to do.
struct ErrorText {
    std::string what;   ///< what failed: "cannot read the volume"
    std::string where;  ///< file, JSON pointer or byte; may be empty
    std::string why;    ///< the cause: "the header promises 4096 slices, the file holds 12"
    std::string remedy; ///< what the reader can do; may be empty
};

/// The one exception of Limner's own code. Exceptions of libraries are wrapped at the edge.
/// Bugs are assertions (`assert`), "not there" is `std::optional`.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, ErrorText text);

    [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
    [[nodiscard]] const ErrorText& text() const noexcept { return text_; }

  private:
    ErrorKind kind_;
    ErrorText text_;
};

/// `what: where: why; remedy`, on one line: line breaks inside the parts become spaces.
std::string oneLine(const ErrorText& text);

} // namespace limner
