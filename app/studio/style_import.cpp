#include "app/studio/style_import.h"

#include "core/style/extraction/extract.h"

namespace limner {

Style importedStyle(const std::filesystem::path& picture, Task& task) {
    std::filesystem::path card = picture;
    Style style;
    style.card = loadStyleCard(card.replace_extension(".json"));
    style.sphere = importMatcap(picture, task);
    if (style.card.origin.empty())
        style.card.origin = picture.filename().string();
    return style;
}

} // namespace limner
