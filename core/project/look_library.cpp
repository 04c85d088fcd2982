#include "core/project/look_library.h"

#include "core/base/error.h"
#include "core/base/user_folder.h"
#include "core/figure/look.h"
#include "core/project/archive.h"
#include "core/project/figure_text.h"
#include "core/project/project.h"
#include "core/style/slug.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>
#include <utility>

namespace limner {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEnding = ".limner";

std::vector<std::byte> thumbnailOf(const fs::path& file) {
    const Archive archive(file);
    const ArchiveEntry* entry = archive.find("thumbnail.png");
    if (!entry)
        return {};
    const std::string bytes = archive.read(*entry);
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
    return {first, first + bytes.size()};
}

LookCard cardOf(const fs::path& file) {
    const nlohmann::json figure = nlohmann::json::parse(readFigureText(file), nullptr, false);
    LookCard card{file.stem().string(), {}, thumbnailOf(file)};
    if (figure.is_object())
        card.name = figure.value("title", std::string());
    if (card.name.empty())
        card.name = card.id;
    return card;
}

} // namespace

LookLibrary::LookLibrary(fs::path folder) : folder_(std::move(folder)) {}

fs::path LookLibrary::standardFolder() { return userFolder("LIMNER_LOOKS", "looks"); }

fs::path LookLibrary::fileOf(const std::string& id) const { return folder_ / (id + kEnding); }

LookLibrary::Listing LookLibrary::list() const {
    Listing listing;
    std::error_code missing; // no folder: no looks yet
    for (const auto& entry : fs::directory_iterator(folder_, missing)) {
        if (entry.path().extension() != kEnding)
            continue;
        try {
            listing.cards.push_back(cardOf(entry.path()));
        } catch (const std::exception& error) {
            listing.problems.emplace_back(error.what());
        }
    }
    std::ranges::sort(listing.cards, {}, [](const LookCard& card) { return std::pair(card.name, card.id); });
    std::ranges::sort(listing.problems);
    return listing;
}

LookCard LookLibrary::write(Figure look, const std::string& name, std::vector<std::byte> thumbnailPng,
                            Task& task) const {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    if (failed)
        throw Error(ErrorKind::noResources, {"cannot keep the look", folder_.string(), failed.message(),
                                             "make the folder writable, or name another in LIMNER_LOOKS"});
    std::vector<std::string> names;
    for (const LookCard& card : list().cards)
        names.push_back(card.name);
    LookCard card;
    card.name =
        numbered(tidyName(name), " ", [&](const std::string& word) { return std::ranges::count(names, word) > 0; });
    card.id = numbered(slugOf(card.name), "-", [&](const std::string& word) { return fs::exists(fileOf(word)); });
    card.thumbnailPng = std::move(thumbnailPng);
    look.title = card.name;
    Document document;
    document.figure = std::move(look);
    SaveOptions options;
    options.thumbnailPng = card.thumbnailPng;
    saveDocument(document, fileOf(card.id), options, task);
    return card;
}

LookCard LookLibrary::add(const Figure& figure, const std::string& name, std::vector<std::byte> thumbnailPng,
                          Task& task) const {
    return write(lookOf(figure), name, std::move(thumbnailPng), task);
}

LookCard LookLibrary::import(const fs::path& file, Task& task) const {
    Document document = openDocument(file, OpenOptions{}, task);
    const std::string title = document.figure.title;
    const auto noted = document.figure.unknown.find("/look");
    Figure look = lookOf(document.figure);
    if (noted != document.figure.unknown.end()) // it is a look already: its own scan's values count
        look.unknown["/look"] = noted->second;
    return write(std::move(look), title.empty() ? file.stem().string() : title,
                 looksLikeArchive(file) ? thumbnailOf(file) : std::vector<std::byte>(), task);
}

Figure LookLibrary::load(const std::string& id, Task& task) const {
    const fs::path file = fileOf(id);
    if (id != slugOf(id) || !fs::exists(file))
        throw Error(ErrorKind::badInput, {"there is no such look", id, "", "see the list of looks"});
    return openDocument(file, OpenOptions{}, task).figure;
}

void LookLibrary::remove(const std::string& id) const {
    std::error_code failed;
    if (id != slugOf(id) || (!fs::remove(fileOf(id), failed) && !failed))
        throw Error(ErrorKind::badInput, {"there is no such look", id, "", "see the list of looks"});
    if (failed)
        throw Error(ErrorKind::noResources,
                    {"cannot remove the look", fileOf(id).string(), failed.message(), "make the folder writable"});
}

} // namespace limner
