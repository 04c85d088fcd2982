#include "renderer/export/finished_bands.h"

#include "core/figure/figure_json.h"
#include "core/project/sha256.h"
#include "core/style/background_picture.h"
#include "core/style/texture_tile.h"

#include <zlib.h>

#include <array>
#include <cstring>
#include <sstream>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeyLength = 64;
constexpr std::array<char, 8> kMagic{'L', 'i', 'm', 'B', 'a', 'n', 'd', '1'};

/// Before each packed band; files do not travel, so it is in the machine's own form.
struct BandHeader {
    std::uint64_t packed = 0;
    std::uint64_t unpacked = 0;
    std::uint64_t crc = 0; ///< of the packed bytes
    BandFacts facts;
};

bool readAll(int file, void* to, std::size_t count, std::int64_t at) {
    auto* bytes = static_cast<char*>(to);
    while (count > 0) {
        const ssize_t got = ::pread(file, bytes, count, at);
        if (got <= 0) {
            return false;
        }
        bytes += got;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

bool writeAll(int file, const void* from, std::size_t count, std::int64_t at) {
    const auto* bytes = static_cast<const char*>(from);
    while (count > 0) {
        const ssize_t put = ::pwrite(file, bytes, count, at);
        if (put <= 0) {
            return false;
        }
        bytes += put;
        at += put;
        count -= static_cast<std::size_t>(put);
    }
    return true;
}

std::uint64_t crcOf(const std::vector<std::byte>& bytes) {
    return crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

void addVolume(Sha256& sum, const std::shared_ptr<const Volume>& volume) {
    if (volume == nullptr) {
        return;
    }
    const glm::ivec3 dims = volume->grid().dims;
    std::vector<std::byte> slice(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) *
                                 bytesPerVoxel(volume->type()));
    const std::size_t row = slice.size() / static_cast<std::size_t>(dims.y);
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            volume->copyRow(y, z, slice.data() + static_cast<std::size_t>(y) * row);
        }
        sum.add(slice);
    }
}

void addPictures(Sha256& sum, const Figure& figure) {
    for (const StyleEntry& style : figure.styles) {
        sum.add(style.id);
        if (style.sphere != nullptr) {
            sum.add(std::as_bytes(style.sphere->pixels()));
        }
        if (style.texture && style.texture->tile != nullptr) {
            sum.add(std::as_bytes(std::span(style.texture->tile->pixels())));
        }
    }
    if (figure.background.picture != nullptr) {
        std::error_code ignored;
        const fs::path& file = figure.background.picture->file();
        const auto changed = fs::last_write_time(file, ignored).time_since_epoch().count();
        sum.add(file.string() + std::to_string(changed));
    }
}

} // namespace

fs::path FinishedBands::fileFor(const fs::path& picture) {
    return picture.parent_path() / ("." + picture.filename().string().substr(0, 200) + ".bands");
}

FinishedBands::FinishedBands(const fs::path& picture, const std::string& key) : path_(fileFor(picture)) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) {
        return;
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) { // another export writes the same picture
        ::close(file_);
        file_ = -1;
        return;
    }
    std::array<char, kMagic.size() + kKeyLength> wanted{};
    std::memcpy(wanted.data(), kMagic.data(), kMagic.size());
    std::memcpy(wanted.data() + kMagic.size(), key.data(), std::min(key.size(), kKeyLength));
    std::array<char, kMagic.size() + kKeyLength> there{};
    end_ = static_cast<std::int64_t>(wanted.size());
    if (readAll(file_, there.data(), there.size(), 0) && there == wanted) {
        readPlaces(end_);
    } else if (::ftruncate(file_, 0) != 0 || !writeAll(file_, wanted.data(), wanted.size(), 0)) {
        remove();
    }
}

FinishedBands::~FinishedBands() {
    if (file_ < 0) {
        return;
    }
    if (places_.empty()) {
        ::unlink(path_.c_str());
    }
    ::close(file_);
}

void FinishedBands::readPlaces(std::int64_t start) {
    const std::int64_t size = ::lseek(file_, 0, SEEK_END);
    BandHeader header;
    while (readAll(file_, &header, sizeof header, start)) {
        const std::int64_t next = start + static_cast<std::int64_t>(sizeof header + header.packed);
        if (next <= start || next > size) { // the last one was not written to its end
            break;
        }
        places_.push_back(start);
        start = next;
    }
    end_ = start;
}

bool FinishedBands::read(std::size_t index, std::vector<std::byte>& bytes, BandFacts& facts) {
    if (file_ < 0 || index >= places_.size()) {
        return false;
    }
    BandHeader header;
    std::vector<std::byte> packed;
    uLongf size = bytes.size();
    const bool whole =
        readAll(file_, &header, sizeof header, places_[index]) && header.unpacked == bytes.size() &&
        (packed.resize(header.packed), true) &&
        readAll(file_, packed.data(), packed.size(), places_[index] + static_cast<std::int64_t>(sizeof header)) &&
        header.crc == crcOf(packed) &&
        ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                     packed.size()) == Z_OK &&
        size == bytes.size();
    if (!whole) { // it is drawn again, and with it all that follow
        end_ = places_[index];
        places_.resize(index);
        return false;
    }
    facts = header.facts;
    return true;
}

void FinishedBands::add(std::size_t index, const std::vector<std::byte>& bytes, const BandFacts& facts) {
    if (file_ < 0 || index != places_.size()) {
        return;
    }
    uLongf size = ::compressBound(bytes.size());
    std::vector<std::byte> packed(size);
    // Level 1: it must not cost more time than it saves.
    if (::compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                    bytes.size(), 1) != Z_OK) {
        return;
    }
    packed.resize(size);
    const BandHeader header{packed.size(), bytes.size(), crcOf(packed), facts};
    const std::int64_t body = end_ + static_cast<std::int64_t>(sizeof header);
    if (!writeAll(file_, &header, sizeof header, end_) || !writeAll(file_, packed.data(), packed.size(), body)) {
        static_cast<void>(!::ftruncate(file_, end_)); // what is whole stays, and the picture may need the room
        ::close(file_);
        file_ = -1;
        return;
    }
    places_.push_back(end_);
    end_ = body + static_cast<std::int64_t>(packed.size());
}

void FinishedBands::remove() {
    if (file_ < 0) {
        return;
    }
    ::unlink(path_.c_str());
    ::close(file_);
    file_ = -1;
}

std::string exportKey(const RenderPlan& plan, const Backend& backend, const PictureOptions& options,
                      const std::string& ending, const BandLayout& bands) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(17); // every double as it is
    const glm::dvec4& paper = options.background;
    text << LIMNER_VERSION << ' ' << backend.name() << ' ' << ending << ' ' << plan.size.x << 'x' << plan.size.y << ' '
         << plan.subPixels << ' ' << bands.rows << ' ' << bands.tileWidth << ' ' << options.dpi << ' '
         << static_cast<int>(options.depth) << ' ' << options.transparent << ' ' << options.memoryBudget << ' '
         << paper.r << ' ' << paper.g << ' ' << paper.b << ' ' << paper.a << '\n';
    Sha256 sum;
    sum.add(text.str());
    if (plan.figure != nullptr) {
        const Figure& figure = *plan.figure;
        sum.add(writeFigure(figure));
        addVolume(sum, figure.volume ? figure.volume->data : nullptr);
        addVolume(sum, figure.secondVolume ? figure.secondVolume->data : nullptr);
        addVolume(sum, figure.labels ? figure.labels->data : nullptr);
        addPictures(sum, figure);
    }
    return sum.hex();
}

} // namespace limner
