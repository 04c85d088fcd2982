#include "core/project/figure_text.h"

#include "core/base/error.h"
#include "core/project/archive.h"

#include <cstdint>
#include <fstream>

namespace limner {

namespace {

// A hundred layers with long curves take less than 1 MiB; more is a mistake or an attack.
constexpr std::uint64_t kLargest = std::uint64_t{64} << 20;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why, const std::string& remedy = "") {
    throw Error(ErrorKind::badInput, {"cannot read the figure", path.string(), why, remedy});
}

std::string textOfFile(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) {
        fail(path, error.message());
    }
    if (size > kLargest) {
        fail(path, "it is larger than any figure is", "is it a scan?");
    }
    std::string text(size, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
        fail(path, "the file cannot be read");
    }
    return text;
}

std::string textInProject(const std::filesystem::path& path) {
    const Archive archive(path);
    const ArchiveEntry* figure = archive.find("figure.json");
    if (figure == nullptr) {
        fail(path, "it holds no figure.json", "is it a Limner project?");
    }
    return archive.read(*figure);
}

} // namespace

std::string readFigureText(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        fail(path, std::filesystem::exists(path, ignored) ? "it is not a file" : "there is no such file");
    }
    return looksLikeArchive(path) || path.extension() == ".limner" ? textInProject(path) : textOfFile(path);
}

} // namespace limner
