#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace limner::cli {

struct ProgramStreams {
    std::ostream& out;
    std::ostream& err;
    int terminal = -1; ///< file descriptor of `err`, for a progress bar; -1: none
};

/// Runs the program with its arguments (without its own name) and returns the exit code: 0 done, 2 wrong usage, 3 bad
/// input, 4 no OpenGL, 5 no memory or disk, 8 pixels that are not finite, 9 a formula failed, 130 cancelled. Throws
/// nothing.
int runProgram(const std::vector<std::string>& arguments, const ProgramStreams& streams);

} // namespace limner::cli
