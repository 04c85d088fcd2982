#include "renderer/text/font_shelf.h"

#include "core/base/error.h"

#include <fontconfig/fontconfig.h>

#include <mutex>
#include <set>
#include <tuple>

namespace limner {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Faces = std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)>;

std::string textOf(FcPattern* pattern, const char* what) {
    FcChar8* text = nullptr;
    return FcPatternGetString(pattern, what, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

int numberOf(FcPattern* pattern, const char* what, int otherwise) {
    int number = 0;
    return FcPatternGetInteger(pattern, what, 0, &number) == FcResultMatch ? number : otherwise;
}

Pattern patternOf(const FontWish& wish) {
    Pattern pattern(FcPatternCreate(), FcPatternDestroy);
    for (const std::string& family : {wish.family, std::string(kDefaultFamily)}) {
        if (!family.empty()) {
            FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
        }
    }
    FcPatternAddInteger(pattern.get(), FC_WEIGHT, wish.bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
    FcPatternAddInteger(pattern.get(), FC_SLANT, wish.italic ? FC_SLANT_ITALIC : FC_SLANT_ROMAN);
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    return pattern;
}

/// What is open already, by file, face and shear; and what wishes and letters led to.
class Shelf {
  public:
    const FontFace& matching(const FontWish& wish) {
        const std::lock_guard lock(mutex_);
        return open(wish);
    }

    const FontFace& holding(const FontWish& wish, char32_t letter) {
        const std::lock_guard lock(mutex_);
        const FontFace& own = open(wish);
        if (own.has(letter)) {
            return own;
        }
        const FontFace*& found = others_[{wish, letter}];
        if (found == nullptr) {
            found = search(wish, letter);
        }
        return found != nullptr ? *found : own;
    }

    static Shelf& get() {
        static auto* shelf = new Shelf; // never taken down: threads may outlast main's end
        return *shelf;
    }

  private:
    const FontFace& open(const FontWish& wish) {
        const FontFace*& face = matched_[wish];
        if (face == nullptr) {
            FcResult result = FcResultNoMatch;
            const Pattern found(FcFontMatch(nullptr, patternOf(wish).get(), &result), FcPatternDestroy);
            if (!found || textOf(found.get(), FC_FILE).empty()) {
                throw Error(ErrorKind::noResources, {"cannot letter the figure", "", "the system has no font",
                                                     "install the package fonts-dejavu-core"});
            }
            face = opened(found.get(), wish);
        }
        return *face;
    }

    const FontFace* opened(FcPattern* pattern, const FontWish& wish) {
        FontFace::Source source;
        source.file = textOf(pattern, FC_FILE);
        source.index = numberOf(pattern, FC_INDEX, 0) & 0xFFFF; // above: instances of variable fonts
        source.family = textOf(pattern, FC_FAMILY);
        source.bold = numberOf(pattern, FC_WEIGHT, FC_WEIGHT_REGULAR) >= FC_WEIGHT_DEMIBOLD;
        source.slanted = wish.italic && numberOf(pattern, FC_SLANT, FC_SLANT_ROMAN) == FC_SLANT_ROMAN;
        auto& face = faces_[{source.file, source.index, source.slanted}];
        if (!face) {
            face = std::make_unique<FontFace>(source);
        }
        return face.get();
    }

    const FontFace* search(const FontWish& wish, char32_t letter) {
        const Pattern pattern = patternOf(wish);
        const std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)> letters(FcCharSetCreate(), FcCharSetDestroy);
        FcCharSetAddChar(letters.get(), letter);
        FcPatternAddCharSet(pattern.get(), FC_CHARSET, letters.get());
        FcResult result = FcResultNoMatch;
        const Pattern found(FcFontMatch(nullptr, pattern.get(), &result), FcPatternDestroy);
        FcCharSet* has = nullptr;
        if (!found || FcPatternGetCharSet(found.get(), FC_CHARSET, 0, &has) != FcResultMatch ||
            FcCharSetHasChar(has, letter) == FcFalse) {
            return nullptr;
        }
        try {
            const FontFace* face = opened(found.get(), wish);
            return face->has(letter) ? face : nullptr;
        } catch (const Error&) { // a font of pictures, or a damaged one
            return nullptr;
        }
    }

    std::mutex mutex_;
    std::map<FontWish, const FontFace*> matched_;
    std::map<std::pair<FontWish, char32_t>, const FontFace*> others_;
    std::map<std::tuple<std::string, int, bool>, std::unique_ptr<FontFace>> faces_;
};

} // namespace

const FontFace& fontFor(const FontWish& wish) { return Shelf::get().matching(wish); }

const FontFace& fontWith(const FontWish& wish, char32_t letter) { return Shelf::get().holding(wish, letter); }

std::vector<std::string> fontFamilies() {
    const Pattern any(FcPatternCreate(), FcPatternDestroy);
    FcPatternAddBool(any.get(), FC_SCALABLE, FcTrue);
    const std::unique_ptr<FcObjectSet, decltype(&FcObjectSetDestroy)> wanted(
        FcObjectSetBuild(FC_FAMILY, static_cast<char*>(nullptr)), FcObjectSetDestroy);
    const Faces faces(FcFontList(nullptr, any.get(), wanted.get()), FcFontSetDestroy);
    std::set<std::string> names;
    for (int i = 0; faces && i < faces->nfont; ++i) {
        names.insert(textOf(faces->fonts[i], FC_FAMILY));
    }
    return {names.begin(), names.end()};
}

} // namespace limner
