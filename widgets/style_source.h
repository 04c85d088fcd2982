#pragma once

#include "core/style/lit_sphere.h"

#include <QImage>
#include <QString>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// Where a style of the gallery is kept.
enum class StyleHome {
    mine,    ///< in the user's own library
    project, ///< in the open project alone
    bundled, ///< comes with Limner
};

/// Ids are unique in one home only: between widgets styles go by a key, "mine:ivory", "project:ivory", "bundled:ivory".
std::string styleKey(StyleHome home, const std::string& id);
/// The id within its home; the key's text where it has no home.
std::string styleIdOf(const std::string& key);
/// Whether the key names a style of that home.
bool livesIn(const std::string& key, StyleHome home);

/// Gives the style of a key with its picture, or null where there is none any more. Called on the interface's thread: a
/// style that was not used lately is read from the disk first, some tens of milliseconds.
using StyleSource = std::function<std::shared_ptr<const Style>(const std::string& key)>;

/// A style as the gallery lists it.
struct GalleryItem {
    StyleHome home = StyleHome::bundled;
    StyleCard card;
    std::string file; ///< as `Style::file`
    QImage ball;      ///< square, on nothing; null: still to come
    bool favourite = false;

    [[nodiscard]] std::string key() const { return styleKey(home, card.id); }
};

/// A line of tags, and back: separated by commas, without blanks around, none twice.
QString tagLine(const std::vector<std::string>& tags);
std::vector<std::string> tagsOfLine(const QString& line);

/// Device pixels of a gallery item's ball: the largest it is shown at, on a screen of twice the usual resolution.
inline constexpr int kGalleryBallPixels = 192;

} // namespace limner
