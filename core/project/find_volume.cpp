#include "core/project/find_volume.h"

#include "core/base/error.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kDepth = 3;
constexpr int kMostFiles = 20'000; // some seconds on a slow disc

/// The last part of a path; of a folder "scan/" too.
std::string lastName(const fs::path& path) {
    return (path.has_filename() ? path.filename() : path.parent_path().filename()).string();
}

/// Visits files and folders, nearest first, each once; hidden ones and links to folders are passed over. Ends where
/// `visit` says so.
class Walk {
  public:
    using Visit = std::function<bool(const fs::directory_entry&)>;

    Walk(Task& task, Visit visit) : task_(task), visit_(std::move(visit)) {}

    void run(std::vector<fs::path> folders) {
        for (int depth = 0; depth <= kDepth && !folders.empty(); ++depth) {
            std::vector<fs::path> next;
            for (const fs::path& folder : folders) {
                std::error_code ignored;
                const fs::path canonical = fs::weakly_canonical(folder, ignored);
                if (seen_.insert(canonical).second && list(canonical, next)) {
                    return;
                }
            }
            folders = std::move(next);
        }
    }

  private:
    bool list(const fs::path& folder, std::vector<fs::path>& next) {
        std::vector<fs::directory_entry> entries;
        std::error_code failure;
        for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
            if (!at->path().filename().string().starts_with('.')) {
                entries.push_back(*at);
            }
        }
        std::sort(entries.begin(), entries.end()); // the same answer on every disc
        for (const fs::directory_entry& entry : entries) {
            task_.throwIfCancelled();
            if (++count_ > kMostFiles || visit_(entry)) {
                return true;
            }
            std::error_code ignored;
            if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) {
                next.push_back(entry.path());
            }
        }
        return false;
    }

    Task& task_;
    Visit visit_;
    std::set<fs::path> seen_;
    int count_ = 0;
};

/// Of a file, or of all files right in a folder: what a DICOM series takes.
std::int64_t bytesOf(const fs::directory_entry& entry) {
    std::error_code ignored;
    if (!entry.is_directory(ignored)) {
        const std::uintmax_t size = entry.is_regular_file(ignored) ? entry.file_size(ignored) : 0;
        return ignored ? 0 : static_cast<std::int64_t>(size);
    }
    std::int64_t sum = 0;
    for (fs::directory_iterator at(entry.path(), ignored), end; !ignored && at != end; at.increment(ignored)) {
        std::error_code failure;
        const std::uintmax_t size = at->is_regular_file(failure) ? at->file_size(failure) : 0;
        sum += failure ? 0 : static_cast<std::int64_t>(size);
    }
    return sum;
}

struct Candidate {
    int rank; ///< 0: name and size, 1: size, 2: name
    fs::path path;
};

std::vector<Candidate> candidatesFor(const VolumeReference& reference, const std::vector<fs::path>& folders,
                                     Task& task) {
    const std::string name = lastName(reference.path.empty() ? reference.absolutePath : reference.path);
    std::vector<Candidate> found;
    Walk(task, [&](const fs::directory_entry& entry) {
        const bool sameName = lastName(entry.path()) == name;
        const bool sameSize = reference.bytes > 0 && bytesOf(entry) == reference.bytes;
        if (sameName || sameSize) {
            found.push_back({sameName && sameSize ? 0 : sameSize ? 1 : 2, entry.path()});
        }
        return false;
    }).run(folders);
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.rank < b.rank; });
    return found;
}

} // namespace

std::vector<fs::path> searchFolders(const fs::path& project, const std::vector<fs::path>& recent) {
    std::vector<fs::path> folders;
    const auto add = [&](const fs::path& folder) {
        const bool root = folder.empty() || folder == folder.root_path();
        if (!root && std::find(folders.begin(), folders.end(), folder) == folders.end()) {
            folders.push_back(folder);
        }
    };
    std::error_code ignored;
    if (!project.empty()) {
        const fs::path own = fs::weakly_canonical(fs::absolute(project), ignored).parent_path();
        add(own);
        add(own.parent_path());
        add(own.parent_path().parent_path());
    }
    for (const fs::path& file : recent) {
        add(fs::weakly_canonical(fs::absolute(file), ignored).parent_path());
    }
    return folders;
}

std::optional<FoundVolume> findVolume(const VolumeReference& reference, const std::vector<fs::path>& folders,
                                      Task& task) {
    task.beginPhase("Looking for the scan");
    const std::vector<Candidate> candidates = candidatesFor(reference, folders, task);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool blind = reference.sha256.empty();
        const bool enough = candidates[i].rank == 0 || (candidates[i].rank == 2 && reference.bytes <= 0);
        if (blind && !enough) {
            continue;
        }
        try {
            Task part(task, static_cast<double>(i) / static_cast<double>(candidates.size()),
                      static_cast<double>(i + 1) / static_cast<double>(candidates.size()));
            ImportOptions options;
            options.raw = reference.raw;
            options.series = reference.series;
            ImportedVolume imported = importVolume(candidates[i].path, options, part);
            if (blind || imported.report.sha256Values == reference.sha256) {
                return FoundVolume{candidates[i].path, std::move(imported)};
            }
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::badInput && error.kind() != ErrorKind::usage) {
                throw;
            } // another kind of file of that size
        }
    }
    return std::nullopt;
}

std::optional<fs::path> findByName(const std::string& name, const std::vector<fs::path>& folders, Task& task) {
    std::optional<fs::path> found;
    const std::string wanted = lastName(name);
    Walk(task, [&](const fs::directory_entry& entry) {
        if (lastName(entry.path()) == wanted) {
            found = entry.path();
        }
        return found.has_value();
    }).run(folders);
    return found;
}

} // namespace limner
