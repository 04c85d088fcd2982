#include "renderer/text/font_face.h"

#include "core/base/error.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <freetype/tttables.h>
#include <hb-ot.h>
#include <hb-subset.h>
#include <hb.h>

#include <algorithm>
#include <cctype>
#include <mutex>

namespace limner {

struct FontFace::Libraries {
    FT_Library library = nullptr; ///< one a face: no two threads share one
    FT_Face face = nullptr;
    hb_face_t* shapes = nullptr;
    hb_font_t* font = nullptr;
    double unitsPerEm = 1000;
    std::mutex mutex; ///< of all below and of `face`
    std::map<std::uint32_t, GlyphOutline> outlines;

    ~Libraries() {
        hb_font_destroy(font);
        hb_face_destroy(shapes);
        if (face != nullptr) {
            FT_Done_Face(face);
        }
        if (library != nullptr) {
            FT_Done_FreeType(library);
        }
    }
};

namespace {

[[noreturn]] void failOn(const std::string& file) {
    throw Error(ErrorKind::badInput, {"cannot read the font", file, "it is no font file with outlines",
                                      "choose another family, or install the package fonts-dejavu-core"});
}

/// FreeType's walk over an outline.
struct Walk {
    GlyphOutline outline;
    double scale = 1;

    void add(GlyphOutline::Step step, std::initializer_list<const FT_Vector*> points) {
        outline.steps.push_back(step);
        for (const FT_Vector* point : points) {
            outline.points.emplace_back(static_cast<double>(point->x) * scale, static_cast<double>(point->y) * scale);
        }
    }
    static Walk& of(void* user) { return *static_cast<Walk*>(user); }
    static int move(const FT_Vector* to, void* user) { return of(user).add(GlyphOutline::Step::move, {to}), 0; }
    static int line(const FT_Vector* to, void* user) { return of(user).add(GlyphOutline::Step::line, {to}), 0; }
    static int conic(const FT_Vector* a, const FT_Vector* to, void* user) {
        return of(user).add(GlyphOutline::Step::conic, {a, to}), 0;
    }
    static int cubic(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
        return of(user).add(GlyphOutline::Step::cubic, {a, b, to}), 0;
    }
};

FaceMetrics metricsOf(FT_Face face, double em) {
    FaceMetrics metrics;
    metrics.ascent = face->ascender / em;
    metrics.descent = -face->descender / em;
    metrics.lowest = glm::dvec2(static_cast<double>(face->bbox.xMin), static_cast<double>(face->bbox.yMin)) / em;
    metrics.highest = glm::dvec2(static_cast<double>(face->bbox.xMax), static_cast<double>(face->bbox.yMax)) / em;
    const auto* table = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(face, FT_SFNT_OS2));
    if (table != nullptr && table->version >= 2 && table->version != 0xFFFFU && table->sCapHeight > 0) {
        metrics.capHeight = table->sCapHeight / em;
        metrics.xHeight = table->sxHeight / em;
    }
    return metrics;
}

std::string plainName(const char* name, const std::string& family) {
    std::string out;
    for (const char c : name != nullptr ? std::string(name) : family) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-') {
            out += c;
        }
    }
    return out.empty() ? "Font" : out;
}

} // namespace

FontFace::FontFace(const Source& source) : source_(source), libraries_(std::make_unique<Libraries>()) {
    Libraries& all = *libraries_;
    if (FT_Init_FreeType(&all.library) != 0 ||
        FT_New_Face(all.library, source.file.c_str(), source.index, &all.face) != 0 || !FT_IS_SCALABLE(all.face) ||
        all.face->units_per_EM == 0) {
        failOn(source.file);
    }
    all.unitsPerEm = all.face->units_per_EM;
    metrics_ = metricsOf(all.face, all.unitsPerEm);
    name_ = plainName(FT_Get_Postscript_Name(all.face), source.family);
    hb_blob_t* blob = hb_blob_create_from_file_or_fail(source.file.c_str());
    if (blob == nullptr) {
        failOn(source.file);
    }
    all.shapes = hb_face_create(blob, static_cast<unsigned>(source.index));
    hb_blob_destroy(blob);
    all.font = hb_font_create(all.shapes);
    hb_ot_font_set_funcs(all.font);
    const int em = static_cast<int>(all.face->units_per_EM);
    hb_font_set_scale(all.font, em, em);
    hb_blob_t* glyf = hb_face_reference_table(all.shapes, HB_TAG('g', 'l', 'y', 'f'));
    trueType_ = hb_blob_get_length(glyf) > 0;
    hb_blob_destroy(glyf);
    hb_face_make_immutable(all.shapes);
    hb_font_make_immutable(all.font);
}

FontFace::~FontFace() = default;

bool FontFace::has(char32_t letter) const {
    hb_codepoint_t glyph = 0;
    return hb_font_get_nominal_glyph(libraries_->font, letter, &glyph) != 0;
}

std::vector<ShapedGlyph> FontFace::shape(std::string_view text) const {
    hb_buffer_t* buffer = hb_buffer_create();
    hb_buffer_add_utf8(buffer, text.data(), static_cast<int>(text.size()), 0, static_cast<int>(text.size()));
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(libraries_->font, buffer, nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
    std::vector<ShapedGlyph> glyphs;
    glyphs.reserve(count);
    glm::dvec2 pen(0);
    for (unsigned i = 0; i < count; ++i) {
        const glm::dvec2 offset(places[i].x_offset, places[i].y_offset);
        const double advance = places[i].x_advance / libraries_->unitsPerEm;
        glyphs.push_back({infos[i].codepoint, pen + offset / libraries_->unitsPerEm, advance, infos[i].cluster});
        pen.x += advance;
    }
    hb_buffer_destroy(buffer);
    return glyphs;
}

double FontFace::advance(std::uint32_t glyph) const {
    return hb_font_get_glyph_h_advance(libraries_->font, glyph) / libraries_->unitsPerEm;
}

const GlyphOutline& FontFace::outline(std::uint32_t glyph) const {
    const std::lock_guard lock(libraries_->mutex);
    const auto known = libraries_->outlines.find(glyph);
    if (known != libraries_->outlines.end()) {
        return known->second;
    }
    Walk walk;
    walk.scale = 1 / libraries_->unitsPerEm;
    if (FT_Load_Glyph(libraries_->face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) == 0 &&
        libraries_->face->glyph->format == FT_GLYPH_FORMAT_OUTLINE) {
        const FT_Outline_Funcs steps{Walk::move, Walk::line, Walk::conic, Walk::cubic, 0, 0};
        FT_Outline_Decompose(&libraries_->face->glyph->outline, &steps, &walk);
    }
    return libraries_->outlines.emplace(glyph, std::move(walk.outline)).first->second;
}

std::string FontFace::subset(std::span<const std::uint32_t> glyphs) const {
    hb_subset_input_t* input = hb_subset_input_create_or_fail();
    if (input == nullptr) {
        return {};
    }
    for (const std::uint32_t glyph : glyphs) {
        hb_set_add(hb_subset_input_glyph_set(input), glyph);
    }
    hb_subset_input_set_flags(input, HB_SUBSET_FLAGS_RETAIN_GIDS);
    hb_face_t* face = hb_subset_or_fail(libraries_->shapes, input);
    hb_subset_input_destroy(input);
    if (face == nullptr) {
        return {};
    }
    hb_blob_t* blob = hb_face_reference_blob(face);
    unsigned length = 0;
    const char* bytes = hb_blob_get_data(blob, &length);
    std::string out(bytes, length);
    hb_blob_destroy(blob);
    hb_face_destroy(face);
    return out;
}

} // namespace limner
