#include "support/test_data.h"

#include <cstdlib>
#include <iostream>

namespace limner::testing {

std::optional<std::filesystem::path> testData(const std::string& relative) {
    static int absent = 0;
    const char* folder = std::getenv("LIMNER_TEST_DATA");
    const auto path = std::filesystem::path(folder != nullptr ? folder : LIMNER_TEST_DATA) / relative;
    if (std::filesystem::exists(path)) {
        return path;
    }
    std::cout << "skipped for want of test data (" << ++absent << "): " << relative << '\n';
    return std::nullopt;
}

} // namespace limner::testing
