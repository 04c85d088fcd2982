#include "renderer/export/pdf_file.h"

#include <zlib.h>

#include <array>
#include <new>

namespace limner {

Deflater::Deflater(Take take) : take_(std::move(take)), stream_(std::make_unique<z_stream>()) {
    if (deflateInit(stream_.get(), Z_DEFAULT_COMPRESSION) != Z_OK)
        throw std::bad_alloc();
}

Deflater::~Deflater() { deflateEnd(stream_.get()); }

void Deflater::write(std::string_view bytes) { pack(bytes, Z_NO_FLUSH); }

void Deflater::finish() { pack({}, Z_FINISH); }

void Deflater::pack(std::string_view bytes, int flush) {
    std::array<char, std::size_t{1} << 15> out;
    stream_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib only reads it
    stream_->avail_in = static_cast<uInt>(bytes.size());
    do {
        stream_->next_out = reinterpret_cast<Bytef*>(out.data());
        stream_->avail_out = static_cast<uInt>(out.size());
        deflate(stream_.get(), flush);
        take_({out.data(), out.size() - stream_->avail_out});
    } while (stream_->avail_out == 0);
}

PdfFile::PdfFile(std::FILE* stream) : stream_(stream) {
    put("%PDF-1.6\n%\xE2\xE3\xCF\xD3\n"); // bytes that tell programs the file is no text
}

void PdfFile::put(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream_);
    at_ += text.size();
}

int PdfFile::reserve() {
    offsets_.push_back(0);
    return static_cast<int>(offsets_.size());
}

void PdfFile::begin(int number) {
    offsets_[static_cast<std::size_t>(number) - 1] = at_;
    put(std::to_string(number) + " 0 obj\n");
}

void PdfFile::write(int number, const std::string& object) {
    begin(number);
    put(object + "\nendobj\n");
}

void PdfFile::beginStream(int number, const std::string& entries) {
    lengthNumber_ = reserve();
    begin(number);
    put("<< " + entries + " /Filter /FlateDecode /Length " + pdfReference(lengthNumber_) + " >>\nstream\n");
    streamStart_ = at_;
    deflater_ = std::make_unique<Deflater>([this](std::string_view packed) { put(packed); });
}

void PdfFile::endStream() {
    deflater_->finish();
    deflater_.reset();
    const std::uint64_t length = at_ - streamStart_;
    put("\nendstream\nendobj\n");
    write(lengthNumber_, std::to_string(length));
}

void PdfFile::writePacked(int number, const std::string& entries, std::string_view packed) {
    begin(number);
    put("<< " + entries + " /Filter /FlateDecode /Length " + std::to_string(packed.size()) + " >>\nstream\n");
    put(packed);
    put("\nendstream\nendobj\n");
}

void PdfFile::finish(int catalog, int info) {
    const std::uint64_t table = at_;
    const std::string count = std::to_string(offsets_.size() + 1);
    put("xref\n0 " + count + "\n0000000000 65535 f \n");
    for (const std::uint64_t offset : offsets_) {
        char line[32];
        std::snprintf(line, sizeof line, "%010llu 00000 n \n", static_cast<unsigned long long>(offset));
        put(line);
    }
    put("trailer\n<< /Size " + count + " /Root " + pdfReference(catalog) + " /Info " + pdfReference(info) +
        " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n");
}

std::string pdfReference(int number) { return std::to_string(number) + " 0 R"; }

std::string pdfText(const std::string& text) {
    std::string out = "<FEFF";
    const auto unit = [&](std::uint32_t code) {
        char hex[8];
        std::snprintf(hex, sizeof hex, "%04X", code & 0xFFFFU);
        out += hex;
    };
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        const int more = lead < 0xC0 ? 0 : (lead < 0xE0 ? 1 : (lead < 0xF0 ? 2 : 3));
        std::uint32_t code = more == 0 ? lead : lead & (0x3FU >> more);
        for (int k = 0; k < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80; ++k)
            code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3FU);
        if (code >= 0x10000) {
            unit(0xD800 + ((code - 0x10000) >> 10));
            unit(0xDC00 + ((code - 0x10000) & 0x3FF));
        } else
            unit(code);
    }
    return out + ">";
}

std::string pdfNumber(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.6f", value);
    return text;
}

} // namespace limner
