#include "core/base/error.h"
#include "core/project/archive.h"

#include <zip.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <set>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

// Limits of spec reliability.md 4.2.
constexpr std::int64_t kMostEntries = 10000;
constexpr std::uint64_t kRatioFree = 100 << 10; ///< smaller entries may pack as well as they like
constexpr std::uint64_t kRatio = 100;
constexpr std::uint64_t kVolumeRatio = 1000; ///< empty air around a patient packs very well
// Per kind, well above what is ever written.
constexpr std::uint64_t kLargestText = std::uint64_t{16} << 20;
constexpr std::uint64_t kLargestPicture = std::uint64_t{512} << 20; ///< a style of 8192², 16-bit RGBA
constexpr std::uint64_t kLargestTotal = std::uint64_t{1} << 30;     ///< everything but the volume
constexpr std::size_t kLongestName = 255;
constexpr const char* kHostile = "it may be hostile: do not trust where it came from";

bool isSafeCharacter(char c) {
    // No control characters, no separators of other systems, no drive letters or streams.
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f && c != '\\' && c != ':';
}

/// Why a name is refused, or null.
const char* nameFault(const std::string& name) {
    if (name.empty() || name.size() > kLongestName) {
        return "an entry's name is empty or too long";
    }
    if (!std::all_of(name.begin(), name.end(), isSafeCharacter)) {
        return "an entry's name holds a character that no project uses";
    }
    if (name.front() == '/') {
        return "an entry's name is an absolute path";
    }
    std::size_t start = 0;
    while (start < name.size()) {
        const std::size_t end = std::min(name.find('/', start), name.size());
        const std::string part = name.substr(start, end - start);
        if (part == ".." || part == "." || part.empty()) {
            return "an entry's name climbs out of the project";
        }
        start = end + 1;
    }
    return nullptr;
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return text;
}

bool hasEnding(const std::string& name, std::initializer_list<const char*> endings) {
    const std::string lower = lowerCase(name);
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return lower.ends_with(ending); });
}

std::uint64_t largestSize(EntryKind kind) {
    switch (kind) {
    case EntryKind::figure:
    case EntryKind::styleCard:
    case EntryKind::thumbnail: return kLargestText;
    case EntryKind::folder: return 0;
    case EntryKind::volume: {
        // An eighth more than the machine's memory: what cannot be loaded need not be unpacked.
        const auto pages = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PHYS_PAGES)));
        return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 8 * 9;
    }
    default: return kLargestPicture;
    }
}

std::uint64_t numberAt(const std::string& bytes, std::size_t offset, int count) {
    std::uint64_t value = 0;
    for (int i = count; i-- > 0;) {
        value = value << 8U | static_cast<unsigned char>(bytes[offset + static_cast<std::size_t>(i)]);
    }
    return value;
}

std::string bytesAt(std::ifstream& file, std::uint64_t offset, std::size_t count) {
    std::string bytes(count, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

/// Start of the zip's directory, from the record at the file's end (APPNOTE 4.3.14 to 4.3.16); past the end when there
/// is none.
std::uint64_t directoryStart(std::ifstream& file, std::uint64_t fileBytes) {
    constexpr std::size_t kEndRecord = 22;
    constexpr std::size_t kLocator = 20; // of the 64-bit record, just before
    constexpr std::size_t kLongestComment = 65535;
    const std::size_t tail = std::min<std::uint64_t>(fileBytes, kEndRecord + kLocator + kLongestComment);
    const std::string bytes = bytesAt(file, fileBytes - tail, tail);
    const std::size_t end = bytes.rfind("PK\x05\x06");
    if (end == std::string::npos || end + kEndRecord > bytes.size()) {
        return fileBytes;
    }
    const std::uint64_t start = numberAt(bytes, end + 16, 4);
    if (start != 0xffffffffU || end < kLocator || bytes.compare(end - kLocator, 4, "PK\x06\x07") != 0) {
        return start;
    }
    const std::string record = bytesAt(file, numberAt(bytes, end - kLocator + 8, 8), 56);
    return record.size() == 56 ? numberAt(record, 48, 8) : fileBytes;
}

/// Whether a name in the zip's directory holds a zero byte, behind which the library would not look.
bool hidesName(const fs::path& path, std::int64_t count) {
    constexpr std::size_t kHeader = 46; // of a directory entry, before its name
    std::error_code ignored;
    std::ifstream file(path, std::ios::binary);
    std::uint64_t offset = directoryStart(file, fs::file_size(path, ignored));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::string header = bytesAt(file, offset, kHeader);
        if (header.size() < kHeader || header.compare(0, 4, "PK\x01\x02") != 0) {
            return true; // not where the library sees it
        }
        const std::size_t length = numberAt(header, 28, 2);
        if (bytesAt(file, offset + kHeader, length).find('\0') != std::string::npos) {
            return true;
        }
        offset += kHeader + length + numberAt(header, 30, 2) + numberAt(header, 32, 2);
    }
    return false;
}

} // namespace

EntryKind kindOf(const std::string& name) {
    const auto pictures = {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".exr", ".webp"};
    if (name == "figure.json") {
        return EntryKind::figure;
    }
    if (name == "thumbnail.png") {
        return EntryKind::thumbnail;
    }
    if (name == "volume.nrrd") {
        return EntryKind::volume;
    }
    if (name.back() == '/') {
        return EntryKind::folder;
    }
    const bool inStyles = name.starts_with("styles/") && name.find('/', 7) == std::string::npos;
    if (inStyles && hasEnding(name, {".json"})) {
        return EntryKind::styleCard;
    }
    if (inStyles && hasEnding(name, pictures)) {
        return EntryKind::style;
    }
    const bool onTop = name.find('/') == std::string::npos;
    return onTop && name.starts_with("background.") && hasEnding(name, pictures) ? EntryKind::background
                                                                                 : EntryKind::other;
}

Archive::Archive(const fs::path& path) : path_(path) {
    open();
    try {
        checkEntries();
    } catch (...) {
        zip_discard(static_cast<zip_t*>(zip_));
        throw;
    }
}

Archive::~Archive() { zip_discard(static_cast<zip_t*>(zip_)); }

void Archive::refuse(const std::string& why, const std::string& remedy) const {
    throw Error(ErrorKind::badInput, {"cannot read the project", path_.string(), why, remedy});
}

void Archive::open() {
    int code = 0;
    zip_ = zip_open(path_.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
    if (zip_ == nullptr) {
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        const std::string why = zip_error_strerror(&error);
        zip_error_fini(&error);
        refuse(why, "take a backup (its name ends in ~) or get the file again");
    }
}

ArchiveEntry Archive::checkedEntry(const struct zip_stat& stat) const {
    const std::string name = stat.name;
    if (const char* fault = nameFault(name)) {
        refuse(fault, kHostile);
    }
    if (stat.encryption_method != ZIP_EM_NONE) {
        refuse("the entry " + name + " is encrypted", "save the project without a password");
    }
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) {
        refuse("the entry " + name + " is packed in a way that projects do not use", "pack it with deflate");
    }
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    zip_file_get_external_attributes(static_cast<zip_t*>(zip_), stat.index, 0, &system, &attributes);
    constexpr zip_uint32_t kTypeMask = 0170000; // of the Unix mode in the upper half
    constexpr zip_uint32_t kRegular = 0100000;
    constexpr zip_uint32_t kFolder = 0040000;
    const zip_uint32_t type = system == ZIP_OPSYS_UNIX ? (attributes >> 16U) & kTypeMask : 0;
    if (type != 0 && type != kRegular && type != kFolder) {
        refuse("the entry " + name + " is a link or a device", "put the file itself into the project");
    }
    const EntryKind kind = kindOf(name);
    if (kind == EntryKind::other && hasEnding(name, {".zip", ".limner", ".gz", ".tar", ".7z", ".xz", ".bz2"})) {
        refuse("the entry " + name + " is an archive in an archive", "take it out of the project");
    }
    const std::uint64_t ratio = kind == EntryKind::volume ? kVolumeRatio : kRatio;
    if (stat.size > largestSize(kind) || (stat.size > kRatioFree && stat.size / ratio > stat.comp_size)) {
        refuse("the entry " + name + " would unpack to " + std::to_string(stat.size) + " bytes", kHostile);
    }
    if (stat.comp_method == ZIP_CM_STORE && stat.size != stat.comp_size) {
        refuse("the entry " + name + " lies about its size", "get the file again");
    }
    return {name, kind, stat.size, stat.comp_size, stat.crc, stat.index};
}

void Archive::checkEntries() {
    auto* zip = static_cast<zip_t*>(zip_);
    const std::int64_t count = zip_get_num_entries(zip, 0);
    if (count > kMostEntries) {
        refuse("it has " + std::to_string(count) + " entries", "a project has at most 10000");
    }
    if (hidesName(path_, count)) {
        refuse("an entry's name holds a zero byte", kHostile);
    }
    std::error_code ignored;
    const std::uint64_t fileBytes = fs::file_size(path_, ignored);
    std::set<std::string> names;
    std::uint64_t total = 0;
    std::uint64_t packed = 0;
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        zip_stat_t stat;
        constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_INDEX | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE |
                                         ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD | ZIP_STAT_CRC;
        if (zip_stat_index(zip, i, ZIP_FL_ENC_RAW, &stat) != 0 || (stat.valid & kNeeded) != kNeeded) {
            refuse("entry " + std::to_string(i) + " is damaged", "get the file again");
        }
        const ArchiveEntry entry = checkedEntry(stat);
        if (!names.insert(lowerCase(entry.name)).second) {
            refuse("two entries are called " + entry.name, kHostile);
        }
        total += entry.kind == EntryKind::volume ? 0 : entry.size;
        packed += entry.packed;
        if (total > kLargestTotal || packed > fileBytes) {
            refuse(packed > fileBytes ? "its entries overlap" : "it would unpack to more than 1 GiB", kHostile);
        }
        entries_.push_back(entry);
    }
}

const ArchiveEntry* Archive::find(const std::string& name) const {
    const auto entry =
        std::find_if(entries_.begin(), entries_.end(), [&](const ArchiveEntry& e) { return e.name == name; });
    return entry == entries_.end() ? nullptr : &*entry;
}

void Archive::readInto(const ArchiveEntry& entry, const std::function<void(std::span<const char>)>& piece) const {
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
        zip_fopen_index(static_cast<zip_t*>(zip_), entry.index, 0), zip_fclose);
    const auto damaged = [&](const std::string& why) {
        refuse("the entry " + entry.name + " is damaged: " + why, "take a backup (its name ends in ~)");
    };
    if (file == nullptr) {
        damaged(zip_strerror(static_cast<zip_t*>(zip_)));
    }
    std::vector<char> buffer(std::min<std::uint64_t>(entry.size + 1, std::uint64_t{1} << 20));
    std::uint64_t done = 0;
    for (;;) {
        const zip_int64_t got = zip_fread(file.get(), buffer.data(), buffer.size());
        if (got < 0) {
            damaged(zip_file_strerror(file.get())); // a wrong CRC too
        }
        done += static_cast<std::uint64_t>(got);
        if (got == 0 || done > entry.size) {
            break;
        }
        piece({buffer.data(), static_cast<std::size_t>(got)});
    }
    if (done != entry.size) {
        damaged("it is not as long as it says");
    }
}

std::string Archive::read(const ArchiveEntry& entry) const {
    std::string bytes;
    readInto(entry, [&](std::span<const char> piece) { bytes.append(piece.data(), piece.size()); });
    return bytes;
}

bool looksLikeArchive(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
        return false;
    }
    char start[4] = {};
    std::ifstream(path, std::ios::binary).read(start, sizeof start);
    return start[0] == 'P' && start[1] == 'K' && (start[2] == 3 || start[2] == 5);
}

TemporaryFolder::TemporaryFolder() {
    std::error_code failure;
    std::string pattern = (fs::temp_directory_path(failure) / "limner-XXXXXX").string();
    if (failure || ::mkdtemp(pattern.data()) == nullptr) {
        throw Error(ErrorKind::noResources,
                    {"cannot make a temporary folder", pattern, "", "free some space or set TMPDIR"});
    }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace limner
