#include "core/project/figure_text.h"

#include "core/base/error.h"

#include <zip.h>

#include <cstdint>
#include <fstream>
#include <memory>

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
    int code = 0;
    const std::unique_ptr<zip_t, decltype(&zip_discard)> archive(zip_open(path.c_str(), ZIP_RDONLY, &code),
                                                                 &zip_discard);
    if (!archive) {
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        const std::string why = zip_error_strerror(&error);
        zip_error_fini(&error);
        fail(path, why);
    }
    zip_stat_t entry;
    if (zip_stat(archive.get(), "figure.json", 0, &entry) != 0 || (entry.valid & ZIP_STAT_SIZE) == 0) {
        fail(path, "there is no figure.json in it", "is it a Limner project?");
    }
    if (entry.size > kLargest) {
        fail(path, "its figure.json is larger than any figure is");
    }
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> file(zip_fopen(archive.get(), "figure.json", 0),
                                                                  &zip_fclose);
    std::string text(entry.size, '\0');
    if (!file || zip_fread(file.get(), text.data(), text.size()) != static_cast<zip_int64_t>(text.size())) {
        fail(path, "its figure.json cannot be unpacked", "an older copy may lie beside it as NAME.limner~");
    }
    return text;
}

} // namespace

std::string readFigureText(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        fail(path, std::filesystem::exists(path, ignored) ? "it is not a file" : "there is no such file");
    }
    return path.extension() == ".limner" ? textInProject(path) : textOfFile(path);
}

} // namespace limner
