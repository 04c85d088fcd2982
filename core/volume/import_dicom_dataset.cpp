#include "core/volume/import_bytes.h"
#include "core/volume/import_dicom.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <utility>

namespace limner::importing {

namespace {

constexpr std::uint32_t kPixelData = dicomTag(0x7fe0, 0x0010);
constexpr std::uint32_t kItem = dicomTag(0xfffe, 0xe000);
constexpr std::uint32_t kItemEnd = dicomTag(0xfffe, 0xe00d);
constexpr std::uint32_t kSequenceEnd = dicomTag(0xfffe, 0xe0dd);
constexpr std::uint32_t kUndefined = 0xffffffff;
constexpr int kDeepest = 16; // sequences in each other; real files stay below 8

struct Syntax {
    bool isExplicit = true;
    bool bigEndian = false;
};

bool isLetter(std::byte b) {
    return (b >= std::byte{'A'} && b <= std::byte{'Z'}) || (b >= std::byte{'a'} && b <= std::byte{'z'});
}

/// Walks one data set, never past the end of its bytes.
class Walker {
  public:
    Walker(std::span<const std::byte> bytes, Syntax syntax) : bytes_(bytes), syntax_(syntax) {}

    /// Reads elements until the end, an item's end, or the pixels. Returns false where the bytes end too early.
    bool readDataSet(DicomDataSet& data, std::size_t end, int depth) {
        data.bigEndian = syntax_.bigEndian;
        while (at_ + 8 <= end) {
            Head head;
            if (!readHead(head, end)) {
                return false;
            }
            if (head.tag == kItemEnd || head.tag == kSequenceEnd) {
                return true;
            }
            if (head.tag < dicomTag(0x0002, 0)) {
                return true; // padding of zeros after the data set
            }
            if (!readElement(data, head, end, depth)) {
                return false;
            }
            if (head.tag == kPixelData || head.tag == dicomTag(0x7fe0, 8) || head.tag == dicomTag(0x7fe0, 9)) {
                return true; // what follows is padding or a signature
            }
        }
        return at_ >= end || depth == 0;
    }

    [[nodiscard]] std::size_t at() const { return at_; }

    struct Head {
        std::uint32_t tag = 0;
        std::array<char, 2> vr{};
        std::uint32_t length = 0;
    };

    bool readHead(Head& head, std::size_t end) {
        const std::uint32_t group = word<std::uint16_t>(bytes_, at_, syntax_.bigEndian);
        const std::uint32_t element = word<std::uint16_t>(bytes_, at_ + 2, syntax_.bigEndian);
        head.tag = dicomTag(group, element);
        const bool delimiter = group == 0xfffe;
        if (!syntax_.isExplicit || delimiter || !isLetter(bytes_[at_ + 4]) || !isLetter(bytes_[at_ + 5])) {
            head.length = word<std::uint32_t>(bytes_, at_ + 4, syntax_.bigEndian);
            at_ += 8;
            return true;
        }
        head.vr = {static_cast<char>(bytes_[at_ + 4]), static_cast<char>(bytes_[at_ + 5])};
        static constexpr std::array<std::string_view, 13> kLong = {"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                                   "SV", "UC", "UN", "UR", "UT", "UV"};
        const std::string_view vr(head.vr.data(), 2);
        if (std::find(kLong.begin(), kLong.end(), vr) == kLong.end()) {
            head.length = word<std::uint16_t>(bytes_, at_ + 6, syntax_.bigEndian);
            at_ += 8;
            return true;
        }
        if (at_ + 12 > end) {
            return false;
        }
        head.length = word<std::uint32_t>(bytes_, at_ + 8, syntax_.bigEndian);
        at_ += 12;
        return true;
    }

  private:
    bool readElement(DicomDataSet& data, const Head& head, std::size_t end, int depth) {
        const bool sequence = std::string_view(head.vr.data(), 2) == "SQ" || isFrameSequence(head.tag);
        if (head.tag == kPixelData && head.length == kUndefined) {
            return readFragments(data.elements[head.tag], end);
        }
        if (head.length == kUndefined) {
            // A sequence, or something unknown that is one in implicit little-endian.
            const Syntax before = syntax_;
            if (std::string_view(head.vr.data(), 2) == "UN") {
                syntax_ = {false, false};
            }
            const bool sound = readItems(data.elements[head.tag], end, depth);
            syntax_ = before;
            return sound;
        }
        if (head.length > end - at_) {
            if (head.tag == kPixelData) {
                data.elements[head.tag].value = bytes_.subspan(at_, end - at_); // checked where it is used
            }
            return false;
        }
        if (sequence && isFrameSequence(head.tag)) {
            const std::size_t next = at_ + head.length;
            const bool sound = readItems(data.elements[head.tag], next, depth);
            at_ = next;
            return sound;
        }
        data.elements[head.tag].value = bytes_.subspan(at_, head.length);
        at_ += head.length;
        return true;
    }

    /// Sequences whose contents matter: those of the functional groups.
    static bool isFrameSequence(std::uint32_t tag) {
        return tag == dicomTag(0x5200, 0x9229) || tag == dicomTag(0x5200, 0x9230) || tag == dicomTag(0x0020, 0x9111) ||
               tag == dicomTag(0x0020, 0x9113) || tag == dicomTag(0x0020, 0x9116) || tag == dicomTag(0x0028, 0x9110) ||
               tag == dicomTag(0x0028, 0x9145);
    }

    bool readItems(DicomElement& element, std::size_t end, int depth) {
        if (depth >= kDeepest) {
            return false;
        }
        while (at_ + 8 <= end) {
            Head head;
            if (!readHead(head, end)) {
                return false;
            }
            if (head.tag == kSequenceEnd) {
                return true;
            }
            if (head.tag != kItem || (head.length != kUndefined && head.length > end - at_)) {
                return false;
            }
            element.items.emplace_back();
            const std::size_t itemEnd = head.length == kUndefined ? end : at_ + head.length;
            if (!readDataSet(element.items.back(), itemEnd, depth + 1)) {
                return false;
            }
            if (head.length != kUndefined) {
                at_ = itemEnd;
            }
        }
        return true;
    }

    bool readFragments(DicomElement& element, std::size_t end) {
        element.encapsulated = true;
        while (at_ + 8 <= end) {
            Head head;
            if (!readHead(head, end)) {
                return false;
            }
            if (head.tag == kSequenceEnd) {
                return true;
            }
            if (head.tag != kItem) {
                return false;
            }
            const std::size_t length = std::min<std::size_t>(head.length, end - at_);
            element.fragments.push_back(bytes_.subspan(at_, length));
            at_ += length;
            if (length < head.length) {
                element.cutOff = true;
                return false;
            }
        }
        return false;
    }

    std::span<const std::byte> bytes_;
    Syntax syntax_;
    std::size_t at_ = 0;
};

/// The inflated data set of a deflated file: grows as it comes, never on a promise.
ByteBuffer inflateRest(const Context& context, std::span<const std::byte> deflated) {
    std::vector<std::byte> out;
    z_stream zlib{};
    constexpr int kRawDeflate = -15;
    if (inflateInit2(&zlib, kRawDeflate) != Z_OK) {
        throw std::bad_alloc();
    }
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> closing(&zlib, &inflateEnd);
    zlib.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(deflated.data()));
    zlib.avail_in = static_cast<uInt>(deflated.size());
    int state = Z_OK;
    constexpr std::size_t kPiece = 1 << 20;
    constexpr std::size_t kSmallest = 256 << 20; // a bomb stops here; real data sets go further if the file is large
    const std::size_t limit = std::max<std::size_t>(kSmallest, deflated.size() * 20);
    while (state == Z_OK && out.size() < limit) {
        context.task.throwIfCancelled();
        const std::size_t before = out.size();
        out.resize(before + kPiece);
        zlib.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        zlib.avail_out = kPiece;
        state = inflate(&zlib, Z_NO_FLUSH);
        out.erase(out.end() - static_cast<std::ptrdiff_t>(zlib.avail_out), out.end());
    }
    ByteBuffer result(out.size());
    if (!out.empty()) {
        std::memcpy(result.data(), out.data(), out.size());
    }
    return result;
}

/// Transfer syntax of the meta header, and where the data set starts.
std::string readMeta(std::span<const std::byte> bytes, std::size_t& at) {
    std::string syntax;
    while (at + 8 <= bytes.size()) {
        if (word<std::uint16_t>(bytes, at, false) != 0x0002) {
            break;
        }
        Walker walker(bytes.subspan(at), {true, false});
        Walker::Head head;
        if (!walker.readHead(head, bytes.size() - at) || head.length > bytes.size() - at - walker.at()) {
            break;
        }
        at += walker.at();
        if (head.tag == dicomTag(0x0002, 0x0010)) {
            syntax.assign(reinterpret_cast<const char*>(bytes.data()) + at, head.length);
            syntax.resize(std::min(syntax.find_last_not_of(std::string_view("\0 ", 2)) + 1, syntax.size()));
        }
        at += head.length;
    }
    return syntax;
}

/// Without a meta header: the first element shows it.
Syntax guessSyntax(std::span<const std::byte> bytes) {
    const bool big = bytes.size() >= 8 && bytes[0] == std::byte{0} && bytes[1] != std::byte{0};
    const bool letters = bytes.size() >= 8 && isLetter(bytes[4]) && isLetter(bytes[5]);
    return {letters, big};
}

} // namespace

const DicomElement* DicomDataSet::find(std::uint32_t tag) const {
    const auto found = elements.find(tag);
    return found == elements.end() ? nullptr : &found->second;
}

std::string DicomDataSet::text(std::uint32_t tag) const {
    const DicomElement* element = find(tag);
    if (element == nullptr) {
        return {};
    }
    std::string_view text(reinterpret_cast<const char*>(element->value.data()), element->value.size());
    text = text.substr(0, text.find('\0'));
    constexpr std::size_t kLongestText = 4096; // numbers and names, no stories
    return std::string(trimmed(text.substr(0, kLongestText)));
}

std::vector<double> DicomDataSet::decimals(std::uint32_t tag) const { return parseNumbers(text(tag), "\\ "); }

std::optional<double> DicomDataSet::decimal(std::uint32_t tag) const {
    const auto numbers = decimals(tag);
    return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::optional<std::uint16_t> DicomDataSet::number16(std::uint32_t tag) const {
    const DicomElement* element = find(tag);
    if (element == nullptr || element->value.size() < 2) {
        return std::nullopt;
    }
    return word<std::uint16_t>(element->value, 0, bigEndian);
}

const DicomDataSet* DicomDataSet::item(std::uint32_t tag) const {
    const DicomElement* element = find(tag);
    return element == nullptr || element->items.empty() ? nullptr : &element->items.front();
}

bool looksLikeDicom(const std::filesystem::path& path) {
    std::array<char, 132> head{};
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), head.size());
    const auto got = static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0));
    if (got == head.size() && std::string_view(head.data() + 128, 4) == "DICM") {
        return true;
    }
    // Without a preamble the file starts with an element of group 2 or 8 with a small number.
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
    const bool little = (at(0) == 8 || at(0) == 2) && at(1) == 0 && at(3) == 0;
    const bool big = at(0) == 0 && (at(1) == 8 || at(1) == 2) && at(2) == 0;
    return got >= 16 && (little || big);
}

std::optional<DicomFile> parseDicom(const Context& context, const std::filesystem::path& path) {
    if (!looksLikeDicom(path)) {
        return std::nullopt;
    }
    DicomFile file;
    auto stream = openStream(context, path, Compression::none);
    file.bytes = ByteBuffer(stream->atMost());
    if (stream->read(file.bytes.span()) != file.bytes.size()) {
        return std::nullopt;
    }
    const std::span<const std::byte> bytes = std::as_const(file.bytes).span();
    std::size_t at = bytes.size() >= 132 && std::memcmp(bytes.data() + 128, "DICM", 4) == 0 ? 132 : 0;
    file.transferSyntax = readMeta(bytes, at);
    std::span<const std::byte> rest = bytes.subspan(at);
    Syntax syntax;
    if (file.transferSyntax.empty()) {
        syntax = guessSyntax(rest);
        file.transferSyntax = syntax.bigEndian ? "1.2.840.10008.1.2.2" : "1.2.840.10008.1.2.1";
    } else if (file.transferSyntax == "1.2.840.10008.1.2") {
        syntax.isExplicit = false;
    } else if (file.transferSyntax == "1.2.840.10008.1.2.2") {
        syntax.bigEndian = true;
    } else if (file.transferSyntax == "1.2.840.10008.1.2.1.99") {
        file.inflated = inflateRest(context, rest);
        rest = std::as_const(file.inflated).span();
        file.transferSyntax = "1.2.840.10008.1.2.1";
    }
    Walker walker(rest, syntax);
    walker.readDataSet(file.data, rest.size(), 0); // what is missing shows where it is asked for
    if (file.data.elements.empty()) {
        return std::nullopt;
    }
    return file;
}

} // namespace limner::importing
