#include "core/base/error.h"
#include "core/project/archive.h"

#include <zip.h>

#include <cerrno>

namespace limner {
namespace {

/// Lets libzip write into a stream that is ours, so that no file appears that we do not know of.
struct StreamSink {
    std::FILE* stream = nullptr;
    zip_error_t error{};

    zip_int64_t fail() {
        zip_error_set(&error, ZIP_ER_WRITE, errno);
        return -1;
    }
};

zip_int64_t sinkCommand(void* state, void* data, zip_uint64_t length, zip_source_cmd_t command) {
    auto& sink = *static_cast<StreamSink*>(state);
    switch (command) {
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(
            ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_BEGIN_WRITE, ZIP_SOURCE_WRITE, ZIP_SOURCE_SEEK_WRITE,
            ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE, ZIP_SOURCE_REMOVE,
            ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_FREE, -1);
    case ZIP_SOURCE_STAT: {
        // New and empty.
        zip_error_set(&sink.error, ZIP_ER_READ, ENOENT);
        return -1;
    }
    case ZIP_SOURCE_ERROR: return zip_error_to_data(&sink.error, data, length);
    case ZIP_SOURCE_WRITE:
        return std::fwrite(data, 1, length, sink.stream) == length ? static_cast<zip_int64_t>(length) : sink.fail();
    case ZIP_SOURCE_TELL_WRITE: return std::ftell(sink.stream);
    case ZIP_SOURCE_SEEK_WRITE: {
        const auto* where = ZIP_SOURCE_GET_ARGS(zip_source_args_seek_t, data, length, &sink.error);
        return where != nullptr && std::fseek(sink.stream, where->offset, where->whence) == 0 ? 0 : sink.fail();
    }
    case ZIP_SOURCE_BEGIN_WRITE:
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_REMOVE:
    case ZIP_SOURCE_FREE: return 0;
    default: zip_error_set(&sink.error, ZIP_ER_OPNOTSUPP, 0); return -1;
    }
}

zip_source_t* sourceOf(zip_t* zip, const NewEntry& entry) {
    if (entry.source != nullptr) {
        // Packed bytes are copied as they are.
        return zip_source_zip(zip, static_cast<zip_t*>(entry.source->handle()), entry.sourceIndex, ZIP_FL_COMPRESSED, 0,
                              -1);
    }
    return entry.file.empty() ? zip_source_buffer(zip, entry.bytes.data(), entry.bytes.size(), 0)
                              : zip_source_file(zip, entry.file.c_str(), 0, -1);
}

bool addEntry(zip_t* zip, const NewEntry& entry) {
    zip_source_t* source = sourceOf(zip, entry);
    if (source == nullptr) {
        return false;
    }
    const zip_int64_t index = zip_file_add(zip, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    return entry.source != nullptr || zip_set_file_compression(zip, static_cast<zip_uint64_t>(index),
                                                               entry.compress ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 0) == 0;
}

} // namespace

void writeArchive(std::FILE* stream, const std::filesystem::path& path, const std::vector<NewEntry>& entries) {
    StreamSink sink{stream, {}};
    zip_error_t error;
    zip_error_init(&error);
    zip_error_init(&sink.error);
    const auto fail = [&](zip_t* zip, std::string why) {
        if (zip != nullptr) {
            why = zip_strerror(zip);
            zip_discard(zip);
        }
        throw Error(ErrorKind::noResources,
                    {"cannot save the project", path.string(), why, "free some space or choose another folder"});
    };
    zip_source_t* target = zip_source_function_create(sinkCommand, &sink, &error);
    zip_t* zip = target == nullptr ? nullptr : zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (zip == nullptr) {
        const std::string why = zip_error_strerror(&error);
        zip_source_free(target);
        fail(nullptr, why);
    }
    for (const NewEntry& entry : entries) {
        if (!addEntry(zip, entry)) {
            fail(zip, "");
        }
    }
    if (zip_close(zip) != 0) {
        fail(zip, "");
    }
}

} // namespace limner
