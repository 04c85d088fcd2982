// Truncated, lying and hostile files: one line, quickly, without much memory, and never a crash.

#include "core/base/error.h"
#include "core/volume/import.h"
#include "support/test_data.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::string gzipped(const std::string& plain) {
    z_stream zlib{};
    deflateInit2(&zlib, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
    std::string out(deflateBound(&zlib, plain.size()) + 32, '\0');
    zlib.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
    zlib.avail_in = static_cast<uInt>(plain.size());
    zlib.next_out = reinterpret_cast<Bytef*>(out.data());
    zlib.avail_out = static_cast<uInt>(out.size());
    deflate(&zlib, Z_FINISH);
    out.resize(zlib.total_out);
    deflateEnd(&zlib);
    return out;
}

template <typename T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// A sound little NIfTI: 4 x 3 x 2 int16.
std::string nifti() {
    std::string b(352 + 4 * 3 * 2 * 2, '\0');
    put(b, 0, std::int32_t{348});
    const std::array<std::int16_t, 8> dim = {3, 4, 3, 2, 1, 1, 1, 1};
    std::memcpy(b.data() + 40, dim.data(), sizeof dim);
    put(b, 70, std::int16_t{4});
    put(b, 72, std::int16_t{16});
    for (std::size_t i = 0; i < 4; ++i) {
        put(b, 76 + 4 * i, 1.0F);
    }
    put(b, 108, 352.0F);
    b.replace(344, 4, std::string("n+1\0", 4));
    for (std::size_t i = 352; i < b.size(); ++i) {
        b[i] = static_cast<char>(i);
    }
    return b;
}

std::string nrrd(const std::string& lines, const std::string& data = std::string(48, 'a')) {
    return "NRRD0004\ntype: short\ndimension: 3\nendian: little\n" + lines + "\n\n" + data;
}

std::string meta(const std::string& lines, const std::string& data = std::string(48, 'a')) {
    return "ObjectType = Image\nNDims = 3\n" + lines + "\nElementDataFile = LOCAL\n" + data;
}

std::string vti(const std::string& extent, const std::string& array, const std::string& before = "") {
    return "<?xml version=\"1.0\"?>\n" + before +
           "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\">"
           "<ImageData WholeExtent=\"" +
           extent + "\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"" + extent + "\"><PointData Scalars=\"a\">" +
           array + "</PointData></Piece></ImageData></VTKFile>";
}

/// One file of a tar archive.
std::string tarEntry(const std::string& name, const std::string& content, std::uint64_t claimed = 0) {
    std::string header(512, '\0');
    header.replace(0, name.size(), name);
    char size[16];
    std::snprintf(size, sizeof size, "%011llo",
                  static_cast<unsigned long long>(claimed != 0 ? claimed : content.size()));
    header.replace(124, 11, size);
    header[156] = '0';
    header.replace(257, 5, "ustar");
    return header + content + std::string((512 - content.size() % 512) % 512, '\0');
}

std::string plist(const std::string& shape, const std::string& before = "") {
    return "<?xml version=\"1.0\"?>" + before +
           "<plist><dict><key>matrix</key><dict><key>dtype</key><string>int16</string><key>filename</key>"
           "<string>matrix.dat</string><key>shape</key><array>" +
           shape +
           "</array></dict><key>spacing</key><array><real>1</real><real>1</real><real>1</real></array></dict></plist>";
}

/// One explicit little-endian DICOM element.
std::string element(std::uint16_t group, std::uint16_t number, const std::string& vr, const std::string& value) {
    std::string bytes(4, '\0');
    put(bytes, 0, group);
    put(bytes, 2, number);
    bytes += vr;
    std::string length(2, '\0');
    put(length, 0, static_cast<std::uint16_t>(value.size()));
    return bytes + length + value;
}

std::string number16(std::uint16_t value) {
    std::string bytes(2, '\0');
    put(bytes, 0, value);
    return bytes;
}

std::string dicom(std::uint16_t rows, std::uint16_t columns, std::uint32_t claimed, const std::string& pixels) {
    std::string bytes = std::string(128, '\0') + "DICM" + element(2, 0x10, "UI", "1.2.840.10008.1.2.1 ") +
                        element(0x0008, 0x0060, "CS", "CT") + element(0x0028, 0x0002, "US", number16(1)) +
                        element(0x0028, 0x0010, "US", number16(rows)) +
                        element(0x0028, 0x0011, "US", number16(columns)) + element(0x0028, 0x0100, "US", number16(16)) +
                        element(0x0028, 0x0101, "US", number16(16)) + element(0x0028, 0x0102, "US", number16(15)) +
                        element(0x0028, 0x0103, "US", number16(0));
    std::string head(12, '\0');
    put(head, 0, std::uint16_t{0x7fe0});
    put(head, 2, std::uint16_t{0x0010});
    head[4] = 'O';
    head[5] = 'W';
    put(head, 8, claimed);
    return bytes + head + pixels;
}

struct Hostile {
    std::string name; ///< file name
    std::string content;
    bool overBudget = false; ///< noResources is as good an answer as badInput
};

std::string changed(std::string bytes, const std::function<void(std::string&)>& change) {
    change(bytes);
    return bytes;
}

std::vector<Hostile> hostileNifti() {
    const std::string sound = nifti();
    const auto with = [&](const std::function<void(std::string&)>& change) { return changed(sound, change); };
    const auto dims = [&](std::int16_t x, std::int16_t y, std::int16_t z) {
        return with([=](std::string& b) {
            put(b, 42, x);
            put(b, 44, y);
            put(b, 46, z);
        });
    };
    return {{"negative.nii", dims(-4, 3, 2)},
            {"zero.nii", dims(0, 3, 2)},
            {"short.nii", dims(40, 30, 20)},
            {"huge.nii", dims(32767, 32767, 32767), true},
            {"huge.nii.gz", gzipped(dims(32767, 32767, 2)), true},
            {"lying.nii.gz", gzipped(dims(1024, 1024, 100))},
            {"rank.nii", with([](std::string& b) { put(b, 40, std::int16_t{9}); })},
            {"rank0.nii", with([](std::string& b) { put(b, 40, std::int16_t{0}); })},
            {"type.nii", with([](std::string& b) { put(b, 70, std::int16_t{777}); })},
            {"spacing0.nii", with([](std::string& b) { put(b, 84, 0.0F); })},
            {"spacingNan.nii", with([](std::string& b) { put(b, 84, std::nanf("")); })},
            {"spacingInf.nii", with([](std::string& b) { put(b, 84, HUGE_VALF); })},
            {"offset.nii", with([](std::string& b) { put(b, 108, 1e9F); })},
            {"offsetNan.nii", with([](std::string& b) { put(b, 108, std::nanf("")); })},
            {"flat.nii", with([](std::string& b) { put(b, 254, std::int16_t{1}); })}, // an sform of zeros
            {"header.nii", sound.substr(0, 200)},
            {"alone.hdr", changed(sound, [](std::string& b) { b.replace(344, 3, "ni1"); })},
            {"alone.img", std::string(1000, 'x')},
            {"allNan.nii", changed(sound + std::string(48, '\0'), [](std::string& b) {
                 put(b, 70, std::int16_t{16});
                 for (std::size_t i = 352; i + 4 <= b.size(); i += 4) {
                     put(b, i, std::nanf(""));
                 }
             })}};
}

std::vector<Hostile> hostileNrrd() {
    const std::string raw = "encoding: raw\nspacings: 1 1 1";
    const std::string bomb = gzipped(std::string(64 << 20, '\0'));
    return {
        {"big.nrrd", nrrd("sizes: 2147483648 2147483648 2147483648\n" + raw)},
        {"big2.nrrd", nrrd("sizes: 65536 65536 65536\n" + raw), true},
        {"overflow.nrrd", nrrd("sizes: 4294967296 4294967296 2\n" + raw)},
        {"negative.nrrd", nrrd("sizes: -4 3 2\n" + raw)},
        {"letters.nrrd", nrrd("sizes: a b c\n" + raw)},
        {"few.nrrd", nrrd("sizes: 4 3\n" + raw)},
        {"short.nrrd", nrrd("sizes: 40 30 20\n" + raw)},
        {"spacing0.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspacings: 1 0 1")},
        {"spacingNan.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspacings: 1 nan 1")},
        {"spacingNegative.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspacings: 1 -1 1")},
        {"spacingInf.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspacings: 1 inf 1")},
        {"directions.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspace: LPS\nspace directions: (1,0,0) (1,0,0) (0,0,1)")},
        {"bracket.nrrd", nrrd("sizes: 4 3 2\nencoding: raw\nspace: LPS\nspace directions: (1,0,0 (0,1,0) (0,0,1)")},
        {"climb.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: ../../../../etc/passwd")},
        {"climb2.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: a/../../b.raw")},
        {"absolute.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: /etc/passwd")},
        {"missing.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: nowhere.raw")},
        {"pattern.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: s%s%n.raw 1 2 1")},
        {"pattern2.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: s%999999999d.raw 1 2 1")},
        {"pattern3.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: s%d.raw 1 2000000000 1")},
        {"self.nhdr", nrrd("sizes: 400 300 2\n" + raw + "\ndata file: self.nhdr")},
        {"folder.nhdr", nrrd("sizes: 4 3 2\n" + raw + "\ndata file: .")},
        {"encoding.nrrd", nrrd("sizes: 4 3 2\nencoding: zrl\nspacings: 1 1 1")},
        {"noise.nrrd", nrrd("sizes: 4 3 2\nencoding: gzip\nspacings: 1 1 1", "this is no gzip stream")},
        {"noise2.nrrd", nrrd("sizes: 4 3 2\nencoding: bzip2\nspacings: 1 1 1", "BZh9 no bzip2 stream")},
        {"words.nrrd", nrrd("sizes: 4 3 2\nencoding: ascii\nspacings: 1 1 1", std::string(60, 'x'))},
        {"range.nrrd", nrrd("sizes: 2 1 1\nencoding: ascii\nspacings: 1 1 1", "99999999 1\n")},
        {"skip.nrrd", nrrd("sizes: 4 3 2\nbyte skip: 99999999999\n" + raw)},
        {"lines.nrrd", nrrd("sizes: 4 3 2\nline skip: 1000000\n" + raw)},
        // The bomb inflates to 64 MiB; the header asks for 60 GiB, over what its 65 KB can ever be.
        {"bomb.nrrd", nrrd("sizes: 32768 32768 32\nencoding: gzip\nspacings: 1 1 1", bomb), true},
        {"endless.nrrd", "NRRD0004\n" + std::string(5 << 20, 'x')}};
}

const std::string kEntityBomb = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">"
                                "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;\">]>";

std::string deepXml() {
    std::string deep;
    for (int i = 0; i < 100000; ++i) {
        deep += "<a>";
    }
    return deep;
}

std::vector<Hostile> hostileMetaImages() {
    const std::string size = "ElementSpacing = 1 1 1\nElementType = MET_SHORT\n";
    return {
        {"big.mha", meta(size + "DimSize = 2147483648 1 1")},
        {"negative.mha", meta(size + "DimSize = -4 3 2")},
        {"short.mha", meta(size + "DimSize = 400 300 200")},
        {"spacing0.mha", meta("ElementSpacing = 0 1 1\nElementType = MET_SHORT\nDimSize = 4 3 2")},
        {"type.mha", meta("ElementType = MET_STRING\nDimSize = 4 3 2")},
        {"channels.mha", meta(size + "DimSize = 4 3 2\nElementNumberOfChannels = -1")},
        {"matrix.mha", meta(size + "DimSize = 4 3 2\nTransformMatrix = 0 0 0 0 0 0 0 0 0")},
        {"zlib.mha", meta(size + "DimSize = 4 3 2\nCompressedData = True", "noise and more noise")},
        {"header.mha", meta(size + "DimSize = 4 3 2\nHeaderSize = -7")},
        {"climb.mhd", "NDims = 3\n" + size + "DimSize = 4 3 2\nElementDataFile = ../x.raw\n"},
        {"list.mhd", "NDims = 3\n" + size + "DimSize = 4 3 2\nElementDataFile = LIST\n/etc/passwd\n/etc/passwd\n"},
        {"none.mhd", "NDims = 3\nDimSize = 4 3 2\n"},
    };
}

std::vector<Hostile> hostileVtk() {
    const std::string array = "<DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">1 2 3</DataArray>";
    return {
        {"big.vtk", "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2147483648 2 2\n"
                    "SPACING 1 1 1\nORIGIN 0 0 0\nPOINT_DATA 8\nSCALARS a short 1\nLOOKUP_TABLE default\n1234"},
        {"count.vtk", "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
                      "SPACING 1 1 1\nORIGIN 0 0 0\nPOINT_DATA 9\nSCALARS a short 1\nLOOKUP_TABLE default\n1234"},
        {"short.vtk", "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
                      "SPACING 1 1 1\nORIGIN 0 0 0\nPOINT_DATA 8\nSCALARS a short 1\nLOOKUP_TABLE default\n1234"},
        {"mesh.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n"},
        {"bomb.vti", vti("0 1 0 1 0 1", "&c;" + array, kEntityBomb)},
        {"deep.vti", vti("0 1 0 1 0 1", deepXml())},
        {"extent.vti", vti("0 2147483647 0 2147483647 0 2147483647", array)},
        {"backward.vti", vti("5 0 0 1 0 1", array)},
        {"nan.vti", vti("nan nan 0 1 0 1", array)},
        {"few.vti", vti("0 1 0 1 0 1", array)},
        {"offset.vti", vti("0 1 0 1 0 1", "<DataArray type=\"UInt8\" format=\"appended\" offset=\"9999999999\"/>")},
        {"binary.vti", vti("0 1 0 1 0 1", "<DataArray type=\"UInt8\" format=\"binary\">AAAA</DataArray>")},
        {"broken.vti", "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\"><ImageData"},
    };
}

std::vector<Hostile> hostileOthers() {
    const std::string integers = "<integer>2</integer><integer>3</integer><integer>4</integer>";
    const std::string big = "<integer>60000</integer><integer>60000</integer><integer>60000</integer>";
    return {
        {"noise.inv3", std::string(3000, 'x')},
        {"empty.inv3", gzipped(std::string(1024, '\0'))},
        {"noplist.inv3", gzipped(tarEntry("a/matrix.dat", "abc"))},
        {"claims.inv3", gzipped(tarEntry("a/main.plist", "abc", 8000000000ULL))},
        {"entities.inv3", gzipped(tarEntry("a/main.plist", plist(integers, kEntityBomb)))},
        {"nomatrix.inv3", gzipped(tarEntry("a/main.plist", plist(integers)))},
        {"size.inv3", gzipped(tarEntry("a/main.plist", plist(integers)) + tarEntry("a/matrix.dat", "abc"))},
        {"huge.inv3", gzipped(tarEntry("a/main.plist", plist(big)) + tarEntry("a/matrix.dat", "abc")), true},
        {"deep.inv3", gzipped(tarEntry("a/main.plist", deepXml()))},
        {"short.dcm", dicom(64, 64, 8192, std::string(100, 'x'))},
        {"lying.dcm", dicom(65535, 65535, 100, std::string(100, 'x'))},
        {"length.dcm", dicom(64, 64, 0xfffffff0U, std::string(100, 'x'))},
        {"zero.dcm", dicom(0, 64, 100, std::string(100, 'x'))},
        {"cut.dcm", dicom(64, 64, 8192, "").substr(0, 150)},
        {"nested.dcm", std::string(128, '\0') + "DICM" + element(2, 0x10, "UI", "1.2.840.10008.1.2.1 ") +
                           [] {
                               std::string open(
                                   "\x00\x52\x30\x92SQ\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff", 20);
                               std::string all;
                               for (int i = 0; i < 20000; ++i) {
                                   all += open;
                               }
                               return all;
                           }()},
        {"noise.png", "\x89PNG\r\n\x1a\n" + std::string(200, 'x')},
        {"noise.tif", std::string("II*\0\x08\0\0\0", 8) + std::string(200, '\xff')},
        {"empty.nii", ""},
        {"text.txt", "Nothing but words.\n"},
        {"text.dcm", "Nothing but words, and enough of them to look like a file of some size, one would think so.\n"},
    };
}

class HostileFolder {
  public:
    HostileFolder() : path_(fs::temp_directory_path() / ("limner_hostile_" + std::to_string(getpid()))) {
        fs::create_directories(path_);
    }
    HostileFolder(const HostileFolder&) = delete;
    HostileFolder& operator=(const HostileFolder&) = delete;
    ~HostileFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

long peakKilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

/// Tells of files that took longer than a second of this process's time. Told, not judged: machines differ.
class SlowTeller {
  public:
    explicit SlowTeller(const fs::path& file) : file_(file), start_(std::clock()) {}
    SlowTeller(const SlowTeller&) = delete;
    SlowTeller& operator=(const SlowTeller&) = delete;
    ~SlowTeller() {
        const double seconds = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
        if (seconds > 1) {
            std::cout << "  " << file_.filename().string() << " took " << seconds << " s\n";
        }
    }

  private:
    fs::path file_;
    std::clock_t start_;
};

void expectRefusal(const fs::path& file, bool overBudget) {
    SCOPED_TRACE(file.filename().string());
    const SlowTeller teller(file);
    try {
        Task task;
        importVolume(file, {}, task);
        ADD_FAILURE() << "was read";
    } catch (const Error& error) {
        EXPECT_TRUE(error.kind() == ErrorKind::badInput || (overBudget && error.kind() == ErrorKind::noResources))
            << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_FALSE(error.text().why.empty());
    }
}

TEST(HostileFiles, AreRefusedInOneLine) {
    const HostileFolder folder;
    std::vector<Hostile> all = hostileNifti();
    for (const auto& more : {hostileNrrd(), hostileMetaImages(), hostileVtk(), hostileOthers()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    const long before = peakKilobytes();
    for (const Hostile& hostile : all) {
        const fs::path file = folder.write(hostile.name, hostile.content);
        expectRefusal(file, hostile.overBudget);
        fs::remove(file);
    }
    const long grown = (peakKilobytes() - before) / 1024;
    std::cout << all.size() << " hostile files, " << grown << " MiB at most\n";
#if !defined(__SANITIZE_ADDRESS__) // the sanitizer keeps freed memory
    EXPECT_LT(grown, 512);
#endif
}

TEST(HostileFiles, FoldersAndAbsentFiles) {
    const HostileFolder folder;
    expectRefusal(folder.path(), false); // empty
    expectRefusal(folder.path() / "absent.nii", false);
    folder.write("notes.txt", "words");
    expectRefusal(folder.path(), false);
    fs::create_directory(folder.path() / "folder.nii");
    expectRefusal(folder.path() / "folder.nii", false);
}

TEST(HostileFiles, TheBudgetIsKept) {
    const HostileFolder folder;
    const fs::path file = folder.write("small.nii", nifti());
    ImportOptions options;
    options.memoryBudget = 10;
    Task task;
    try {
        importVolume(file, options, task);
        ADD_FAILURE() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::noResources);
    }
    options.memoryBudget = 0;
    EXPECT_EQ(importVolume(file, options, task).volume->grid().dims, glm::ivec3(4, 3, 2)); // else sound
}

TEST(HostileFiles, CancelledTasksStop) {
    const HostileFolder folder;
    Task task;
    task.cancel();
    try {
        importVolume(folder.write("small.nii", nifti()), {}, task);
        ADD_FAILURE() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
}

/// Reads a damaged file; anything but Error ends the test run.
void tryDamaged(const fs::path& file, int& read, int& refused) {
    const SlowTeller teller(file);
    try {
        Task task;
        ImportOptions options;
        options.memoryBudget = std::uint64_t{1} << 30;
        importVolume(file, options, task);
        ++read;
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        ++refused;
    }
}

/// Files of a folder of the test data, at most `each` of one subfolder.
std::vector<fs::path> soundFiles(const std::string& folder, std::uintmax_t largest, int each) {
    std::vector<fs::path> files;
    const auto root = testing::testData(folder);
    if (!root) {
        return files;
    }
    for (const auto& entry : fs::recursive_directory_iterator(*root)) {
        if (entry.is_regular_file() && entry.file_size() <= largest) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::map<fs::path, int> taken;
    std::erase_if(files, [&](const fs::path& file) { return ++taken[file.parent_path()] > each; });
    return files;
}

/// Damages every file in a few seeded ways: cut short, bits flipped near the front and anywhere.
void damageAll(const std::string& data, std::uintmax_t largest, int each) {
    const HostileFolder folder;
    std::mt19937 random(20240607); // any seed: the same files every time
    int read = 0;
    int refused = 0;
    for (const fs::path& file : soundFiles(data, largest, each)) {
        std::ifstream in(file, std::ios::binary);
        const std::string sound((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
        if (sound.empty()) {
            continue;
        }
        for (int n = 0; n < 4; ++n) {
            std::string damaged = sound;
            if (n == 0) {
                damaged.resize(random() % sound.size());
            } else {
                const std::size_t reach = n == 1 ? std::min<std::size_t>(512, sound.size()) : sound.size();
                for (int flips = 0; flips < 8; ++flips) {
                    damaged[random() % reach] ^= static_cast<char>(1U << random() % 8);
                }
            }
            SCOPED_TRACE(file.filename().string() + " " + std::to_string(n));
            const std::string name =
                file.parent_path().filename().string() + "_" + std::to_string(n) + "_" + file.filename().string();
            const fs::path copy = folder.write(name, damaged);
            tryDamaged(copy, read, refused);
            fs::remove(copy);
        }
    }
    std::cout << "  " << data << ": " << read << " damaged files could be read, " << refused << " were refused\n";
}

TEST(DamagedFiles, OfTheZooAreReadOrRefused) { damageAll("zoo", 120000, 60); }

TEST(DamagedFiles, OfDicomAreReadOrRefused) {
    damageAll("dicom/single_files", 60000, 60);
    damageAll("dicom/odd/transfer_syntaxes", 60000, 3);
}

} // namespace
} // namespace limner
