#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/style/lit_sphere.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// The folder's cards at once, its pictures when they are asked for.
class StyleFolder {
  public:
    explicit StyleFolder(const fs::path& folder) {
        std::vector<std::pair<StyleCard, fs::path>> found;
        std::error_code missing;
        for (const auto& entry : fs::directory_iterator(folder, missing)) {
            const fs::path& card = entry.path();
            fs::path picture = card;
            picture.replace_extension(".png");
            if (card.extension() == ".json" && fs::exists(picture)) {
                found.emplace_back(loadStyleCard(card), picture);
            }
        }
        if (found.empty()) {
            throw Error(ErrorKind::badInput, {"cannot find the bundled styles", folder.string(),
                                              missing ? missing.message() : "no style in this folder",
                                              "set LIMNER_RESOURCES to the folder that holds `styles` and `presets`"});
        }
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return std::pair(a.first.name, a.first.id) < std::pair(b.first.name, b.first.id);
        });
        for (auto& [card, picture] : found) {
            cards_.push_back(card);
            const std::string file = "bundled:" + card.id;
            styles_.push_back({std::move(card), nullptr, file});
            pictures_.push_back(std::move(picture));
        }
        loaded_ = std::make_unique<std::once_flag[]>(styles_.size());
    }

    [[nodiscard]] const std::vector<StyleCard>& cards() const { return cards_; }

    /// With its picture; a failure is thrown again on the next call.
    const Style& load(std::size_t i) {
        std::call_once(loaded_[i], [&] { styles_[i].sphere = loadStyle(pictures_[i]).sphere; });
        return styles_[i];
    }

    const std::vector<Style>& loadAll() {
        std::call_once(allLoaded_, [&] {
            // Isolated: while it waits, this thread must not take up a task that asks for the styles itself.
            tbb::this_task_arena::isolate(
                [&] { tbb::parallel_for(std::size_t{0}, styles_.size(), [&](std::size_t i) { load(i); }); });
        });
        return styles_;
    }

  private:
    std::vector<StyleCard> cards_;
    std::vector<Style> styles_;
    std::vector<fs::path> pictures_;
    std::unique_ptr<std::once_flag[]> loaded_;
    std::once_flag allLoaded_;
};

StyleFolder& bundledFolder() {
    static StyleFolder folder(resourcesFolder() / "styles");
    return folder;
}

} // namespace

const std::vector<StyleCard>& bundledStyleCards() { return bundledFolder().cards(); }

const std::vector<Style>& bundledStyles() { return bundledFolder().loadAll(); }

const Style* findBundledStyle(const std::string& id) {
    const auto& cards = bundledStyleCards();
    const auto card = std::find_if(cards.begin(), cards.end(), [&](const StyleCard& c) { return c.id == id; });
    return card == cards.end() ? nullptr : &bundledFolder().load(static_cast<std::size_t>(card - cards.begin()));
}

} // namespace limner
