#include "app/cli/program.h"

#include <iostream>

#include <unistd.h>

int main(int argc, char** argv) {
    return limner::cli::runProgram({argv + (argc > 0 ? 1 : 0), argv + argc}, {std::cout, std::cerr, STDERR_FILENO});
}
