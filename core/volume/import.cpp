#include "core/volume/import.h"

#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <algorithm>
#include <exception>
#include <new>

namespace limner {

namespace {

using namespace importing;
namespace fs = std::filesystem;

using Reader = StoredVolume (*)(Context&);

std::uint64_t defaultBudget() { return machineMemory() / 4 * 3; }

bool startsAsPicture(const std::string& head) {
    return head.starts_with("\x89PNG\r\n\x1a\n") || head.starts_with(std::string("II*\0", 4)) ||
           head.starts_with(std::string("MM\0*", 4)) || head.starts_with(std::string("II+\0", 4)) ||
           head.starts_with(std::string("MM\0+", 4));
}

/// A tar archive: "ustar", or the names and octal sizes of the older form.
bool startsAsTar(const std::string& head) { return head.size() >= 512 && head.compare(257, 5, "ustar") == 0; }

/// The reader of a file, by its content first and its name second.
Reader readerOf(const Context& context) {
    const std::string name = lowered(context.path.filename().string());
    if (!context.options.raw.empty()) {
        return readRaw;
    }
    if (fileLength(context, context.path) == 0) {
        context.refuse("the file is empty");
    }
    if (name.ends_with(".img") || name.ends_with(".img.gz")) {
        return readNifti;
    }
    const std::string head = headOf(context.path, 1024);
    if (head.size() >= 132 && head.compare(128, 4, "DICM") == 0) {
        return readDicom; // first: its preamble may be another format's header
    }
    if (head.starts_with("NRRD000")) {
        return readNrrd;
    }
    if (head.starts_with("# vtk DataFile")) {
        return readLegacyVtk;
    }
    if (startsAsPicture(head)) {
        return readPictures;
    }
    if (name.ends_with(".inv3") || startsAsTar(head)) {
        return readInvesalius;
    }
    if (startsAsNifti(head)) {
        return readNifti;
    }
    if (head.find("<VTKFile") != std::string::npos || name.ends_with(".vti")) {
        return readVti;
    }
    if (name.ends_with(".mha") || name.ends_with(".mhd") || head.starts_with("ObjectType")) {
        return readMetaImage;
    }
    return readDicom; // without a preamble; refuses what it is not
}

Reader readerOfFolder(const Context& context) {
    if (!context.options.raw.empty()) {
        context.refuse("a folder has no raw bytes", "name the file");
    }
    return isPictureFolder(context.path) ? readPictures : readDicom;
}

std::uintmax_t bytesOf(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) {
        return fs::file_size(path, ignored);
    }
    std::uintmax_t sum = 0;
    for (fs::recursive_directory_iterator it(path, ignored), end; it != end && !ignored; it.increment(ignored)) {
        std::error_code unread;
        if (it->is_regular_file(unread)) {
            sum += it->file_size(unread);
        }
    }
    return sum;
}

ImportedVolume importChecked(Context& context) {
    if (isBuiltin(context.path)) {
        return finish(readBuiltin(context), context);
    }
    std::error_code failed;
    if (!fs::exists(context.path, failed)) {
        throw Error(ErrorKind::badInput,
                    {"cannot read the volume", context.path.string(), "there is no such file or folder", ""});
    }
    context.task.throwIfCancelled();
    context.task.beginPhase("reading " + context.path.filename().string());
    const bool folder = fs::is_directory(context.path, failed);
    const Reader read = folder ? readerOfFolder(context) : readerOf(context);
    StoredVolume stored = read(context);
    if (context.report.fileBytes == 0) {
        context.report.fileBytes = bytesOf(context.path);
    }
    return finish(std::move(stored), context);
}

} // namespace

ImportedVolume importVolume(const fs::path& path, const ImportOptions& options, Task& task) {
    ImportReport report;
    fs::path plain = path.has_filename() ? path : path.parent_path(); // "folder/"
    Context context{std::move(plain), options, task, report,
                    options.memoryBudget != 0 ? options.memoryBudget : defaultBudget()};
    try {
        return importChecked(context);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources,
                    {"cannot read the volume", context.path.filename().string(), "there is not enough memory",
                     "close other programs or load a part of it"});
    } catch (const std::exception& problem) {
        context.refuse(std::string("it is damaged (") + problem.what() + ")", "copy or export the file anew");
    }
}

} // namespace limner
