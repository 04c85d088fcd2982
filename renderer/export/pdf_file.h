#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s; // zlib's

namespace limner {

/// Packs bytes as they come.
class Deflater {
  public:
    using Take = std::function<void(std::string_view)>;
    explicit Deflater(Take take);
    ~Deflater();
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;
    void write(std::string_view bytes);
    void finish();

  private:
    void pack(std::string_view bytes, int flush);
    Take take_;
    std::unique_ptr<z_stream_s> stream_;
};

/// A PDF file's numbered objects, in the order in which they are written.
class PdfFile {
  public:
    explicit PdfFile(std::FILE* stream);

    /// A number for an object that is written later.
    int reserve();
    void write(int number, const std::string& object);
    /// A packed stream; `entries` are those of its dictionary besides length and filter.
    void beginStream(int number, const std::string& entries);
    void streamBytes(std::string_view bytes) { deflater_->write(bytes); }
    void endStream();
    /// A stream that is packed already.
    void writePacked(int number, const std::string& entries, std::string_view packed);
    /// The table of objects and the trailer.
    void finish(int catalog, int info);

  private:
    void put(std::string_view text);
    void begin(int number);

    std::FILE* stream_;
    std::uint64_t at_ = 0;
    std::vector<std::uint64_t> offsets_; ///< of object i + 1
    std::unique_ptr<Deflater> deflater_;
    std::uint64_t streamStart_ = 0;
    int lengthNumber_ = 0;
};

std::string pdfReference(int number);
/// A string for people, from UTF-8.
std::string pdfText(const std::string& text);
/// A number without an exponent.
std::string pdfNumber(double value);

} // namespace limner
