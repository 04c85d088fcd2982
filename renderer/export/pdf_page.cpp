#include "renderer/export/compact_text.h"
#include "renderer/export/pdf_file.h"
#include "renderer/export/pdf_fonts.h"
#include "renderer/export/srgb_profile.h"
#include "renderer/export/vector_page.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace limner {

namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kLongestEdge = 14400; ///< in the page's units: what readers promise to show
constexpr int kOpacities = 255;        ///< steps

/// An outline as path operators; arcs as cubic curves, at most a quarter turn each (3e-4 of the radius off).
class PdfPathSink {
  public:
    explicit PdfPathSink(CompactText& text) : text_(text) {}
    void moveTo(glm::vec2 place) { put(place, "m\n"); }
    void lineTo(glm::vec2 place) { put(place, "l\n"); }
    void arcTo(glm::vec2 centre, float radius, glm::vec2 from, glm::vec2 to) {
        constexpr float kQuarter = 1.5708F;
        const float angle = arcAngle(from, to);
        const float parts = std::max(std::ceil(angle / kQuarter - 0.01F), 1.0F);
        const float step = angle / parts;
        const float handle = 4.0F / 3 * std::tan(step / 4);
        glm::vec2 at = from;
        for (float part = 1; part <= parts; ++part) {
            const glm::vec2 next = part == parts ? to
                                                 : glm::vec2(at.x * std::cos(step) + at.y * std::sin(step),
                                                             at.y * std::cos(step) - at.x * std::sin(step));
            put(centre + radius * (at + handle * glm::vec2(at.y, -at.x)), "");
            put(centre + radius * (next - handle * glm::vec2(next.y, -next.x)), "");
            put(centre + radius * next, "c\n");
            at = next;
        }
    }

  private:
    void put(glm::vec2 place, const char* command) {
        text_.number(place.x, kPlaceDecimals) << ' ';
        text_.number(place.y, kPlaceDecimals) << ' ' << command;
    }
    CompactText& text_;
};

/// Each glyph's code as PDF writes it. A cluster's letters go with its first glyph.
std::vector<std::string> codesOf(const TextRun& run, PdfFonts& fonts) {
    std::set<std::size_t> starts;
    for (const ShapedGlyph& glyph : run.glyphs)
        starts.insert(glyph.cluster);
    std::set<std::size_t> shown;
    std::vector<std::string> codes;
    for (const ShapedGlyph& glyph : run.glyphs) {
        std::string letters;
        if (shown.insert(glyph.cluster).second) {
            const auto next = starts.upper_bound(glyph.cluster);
            const std::size_t end = next == starts.end() ? run.span.text.size() : *next;
            letters = run.span.text.substr(glyph.cluster, end - glyph.cluster);
        }
        char text[16];
        std::snprintf(text, sizeof text, "<%04X>", static_cast<unsigned>(fonts.code(*run.face, glyph.id, letters)));
        codes.emplace_back(text);
    }
    return codes;
}

class PdfPage : public VectorPage {
  public:
    PdfPage(const PageHeader& header, std::FILE* stream)
        : header_(header), file_(stream), text_([this](std::string_view piece) { file_.streamBytes(piece); }) {
        for (int* number : {&catalog_, &pages_, &page_, &info_})
            *number = file_.reserve();
        unit_ = std::max(1.0, std::ceil(std::max(header.paperMm.x, header.paperMm.y) * kPointsPerMm / kLongestEdge));
    }

    void beginLayer(const std::string& name) override {
        layers_.push_back(file_.reserve());
        file_.write(layers_.back(), "<< /Type /OCG /Name " + pdfText(name) + " >>");
    }
    void endLayer() override { endContent(); }

    void fill(const glm::dvec3& rgb) override {
        beginContent();
        for (int i = 0; i < 3; ++i)
            text_.number(std::clamp(rgb[i], 0.0, 1.0), 5) << ' ';
        text_ << "rg 0 0 ";
        text_.number(header_.paperMm.x, 6) << ' ';
        text_.number(header_.paperMm.y, 6) << " re f\n";
        filling_.reset();
    }

    void beginPicture(glm::ivec2 size, double /*dpi*/) override {
        endContent();
        pictures_.push_back(file_.reserve());
        masks_.push_back(file_.reserve());
        pictureSize_ = "/Type /XObject /Subtype /Image /BitsPerComponent 8 /Width " + std::to_string(size.x) +
                       " /Height " + std::to_string(size.y);
        file_.beginStream(pictures_.back(),
                          pictureSize_ + " /ColorSpace /DeviceRGB /SMask " + pdfReference(masks_.back()));
        mask_.clear();
        maskPacker_ = std::make_unique<Deflater>([this](std::string_view packed) { mask_ += packed; });
    }
    void pictureRows(std::span<const std::byte> rgba, int /*rows*/) override {
        std::string colours(rgba.size() / 4 * 3, '\0');
        std::string alphas(rgba.size() / 4, '\0');
        for (std::size_t i = 0; i < alphas.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                colours[i * 3 + k] = static_cast<char>(rgba[i * 4 + k]);
            alphas[i] = static_cast<char>(rgba[i * 4 + 3]);
        }
        file_.streamBytes(colours);
        maskPacker_->write(alphas);
    }
    void endPicture() override {
        endPictureData();
        beginContent();
        placePicture({{0, 0}, header_.paperMm}, pictures_.size());
    }

    /// A line of no length with round ends: a few bytes, and every reader draws a disc.
    void dot(const Dot& dot) override {
        beginContent();
        stroking(dot.rgb, 2 * dot.radiusMm, dot.opacity);
        for (const char* command : {" m ", " l S\n"}) {
            text_.number(dot.placeMm.x, kPlaceDecimals) << ' ';
            text_.number(dot.placeMm.y, kPlaceDecimals) << command;
        }
    }

    void line(std::span<const OutlinePoint> points, const Stroke& stroke) override {
        beginContent();
        stroking(stroke.rgb, 2 * points.front().radius, stroke.opacity);
        for (const OutlinePoint& point : points) {
            text_.number(point.place.x, kPlaceDecimals) << ' ';
            text_.number(point.place.y, kPlaceDecimals) << (&point == points.data() ? " m\n" : " l\n");
        }
        text_ << "S\n";
    }

    void outline(std::span<const OutlinePoint> points, const Stroke& stroke) override {
        beginContent();
        opacity(stroke.opacity);
        if (filling_ != stroke.rgb)
            colour(stroke.rgb, "rg\n");
        filling_ = stroke.rgb;
        PdfPathSink sink(text_);
        traceStroke(points, sink);
        text_ << "f\n";
    }

    void text(const PaperText& text) override;

    void bar(const PaperBar& bar) override {
        beginContent();
        fillWith(bar.rgb);
        text_.number(bar.box.lowMm.x, kPlaceDecimals) << ' ';
        text_.number(bar.box.lowMm.y, kPlaceDecimals) << ' ';
        text_.number(bar.box.sizeMm().x, kPlaceDecimals) << ' ';
        text_.number(bar.box.sizeMm().y, kPlaceDecimals) << " re f\n";
    }

    void ball(const PaperBall& ball) override {
        if (!ball.sphere) {
            dot({glm::vec2(ball.centreMm), 0, static_cast<float>(ball.radiusMm), 1, ball.rgb});
            return;
        }
        const std::vector<std::uint8_t> rgba = ballBytes(*ball.sphere);
        beginPicture({kBallPixels, kBallPixels}, 0);
        pictureRows(std::as_bytes(std::span(rgba)), kBallPixels);
        endPictureData();
        beginContent();
        opacity(1);
        placePicture({ball.centreMm - ball.radiusMm, ball.centreMm + ball.radiusMm}, pictures_.size());
    }

    void finish() override;

  private:
    void placePicture(const SheetBox& box, std::size_t number) {
        text_ << "q ";
        text_.number(box.sizeMm().x, 6) << " 0 0 ";
        text_.number(-box.sizeMm().y, 6) << ' ';
        text_.number(box.lowMm.x, 6) << ' ';
        text_.number(box.highMm.y, 6) << " cm /P" << std::to_string(number) << " Do Q\n";
    }
    void endPictureData() {
        file_.endStream();
        maskPacker_->finish();
        maskPacker_.reset();
        file_.writePacked(masks_.back(), pictureSize_ + " /ColorSpace /DeviceGray", mask_);
        mask_ = {};
    }
    void fillWith(const InkColour& rgb) {
        opacity(1);
        if (filling_ != rgb)
            colour(rgb, "rg\n");
        filling_ = rgb;
    }
    void textRun(const PaperText& text, const TextRun& run);
    void beginContent();
    void endContent();
    [[nodiscard]] std::string resources(int profile, const std::string& fonts) const;

    void colour(const InkColour& rgb, const char* command) {
        for (int i = 0; i < 3; ++i)
            text_.number(rgb[i] / 255.0, 5) << ' ';
        text_ << command;
    }
    void opacity(float opacity) {
        const int step = std::clamp(static_cast<int>(std::lround(opacity * kOpacities)), 1, kOpacities);
        if (step == opacity_)
            return;
        opacity_ = step;
        opacities_.insert(step);
        text_ << "/O" << std::to_string(step) << " gs\n";
    }
    void stroking(const InkColour& rgb, float widthMm, float share) {
        opacity(share);
        if (drawing_ != rgb)
            colour(rgb, "RG\n");
        drawing_ = rgb;
        const std::int64_t width = std::llround(widthMm * 10000.0);
        if (width != width_)
            text_.fixed(width, 4) << " w\n";
        width_ = width;
    }

    PageHeader header_;
    PdfFile file_;
    PdfFonts fonts_;
    CompactText text_;
    double unit_ = 1; ///< points
    int catalog_ = 0;
    int pages_ = 0;
    int page_ = 0;
    int info_ = 0;
    std::vector<int> layers_;
    std::vector<int> contents_;
    std::vector<int> pictures_;
    std::vector<int> masks_;
    std::set<int> opacities_;
    bool open_ = false; ///< a piece of content
    std::optional<InkColour> drawing_;
    std::optional<InkColour> filling_;
    std::int64_t width_ = 0;
    int opacity_ = 0;
    std::string pictureSize_;
    std::string mask_;
    std::unique_ptr<Deflater> maskPacker_;
};

void PdfPage::text(const PaperText& text) {
    beginContent();
    fillWith(text.rgb);
    for (const TextRun& run : text.block.runs)
        textRun(text, run);
}

/// Glyphs one after the other, moved by thousandths of an em where the font's own widths would not lead to their
/// places; one that lies higher or lower, such as an accent, begins anew. The page's y goes down, letters go up.
void PdfPage::textRun(const PaperText& text, const TextRun& run) {
    const FontFace& face = *run.face;
    const double shear = face.source().slanted ? FontFace::kShear : 0;
    const auto codes = codesOf(run, fonts_);
    text_ << "BT " << fonts_.name(face) << ' ';
    text_.number(run.emMm, 4) << " Tf\n";
    double pen = 0;
    double height = NAN; // of the glyphs so far, in ems
    for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
        const ShapedGlyph& glyph = run.glyphs[i];
        if (glyph.place.y != height) {
            text_ << (std::isnan(height) ? "1 0 " : "] TJ\n1 0 ");
            const glm::dvec2 at = text.atMm + run.originMm + glm::dvec2(glyph.place.x, -glyph.place.y) * run.emMm;
            text_.number(shear, 3) << " -1 ";
            text_.number(at.x, kPlaceDecimals) << ' ';
            text_.number(at.y, kPlaceDecimals) << " Tm [";
            height = glyph.place.y;
            pen = glyph.place.x;
        }
        const auto back = std::llround((pen - glyph.place.x) * 1000);
        if (back != 0)
            text_.fixed(back, 0);
        text_ << codes[i];
        pen += face.advance(glyph.id) - static_cast<double>(back) / 1000;
    }
    text_ << (std::isnan(height) ? "ET\n" : "] TJ ET\n");
}

void PdfPage::beginContent() {
    if (open_)
        return;
    open_ = true;
    drawing_.reset();
    filling_.reset();
    width_ = -1;
    opacity_ = kOpacities;
    contents_.push_back(file_.reserve());
    file_.beginStream(contents_.back(), "");
    const double scale = kPointsPerMm / unit_;
    text_ << "q " << pdfNumber(scale) << " 0 0 " << pdfNumber(-scale) << " 0 " << pdfNumber(header_.paperMm.y * scale)
          << " cm 1 J 1 j\n/OC /L" << std::to_string(layers_.size()) << " BDC\n";
}

void PdfPage::endContent() {
    if (!open_)
        return;
    text_ << "EMC Q\n";
    text_.flush();
    file_.endStream();
    open_ = false;
}

std::string PdfPage::resources(int profile, const std::string& fonts) const {
    std::string text = "<< ";
    if (!fonts.empty())
        text += "/Font << " + fonts + ">> ";
    if (profile > 0)
        text += "/ColorSpace << /DefaultRGB [/ICCBased " + pdfReference(profile) + "] >> ";
    const auto list = [&](const char* kind, const char* prefix, const std::vector<int>& objects) {
        text += std::string(kind) + " << ";
        for (std::size_t i = 0; i < objects.size(); ++i)
            text += prefix + std::to_string(i + 1) + " " + pdfReference(objects[i]) + " ";
        text += ">> ";
    };
    list("/Properties", "/L", layers_);
    list("/XObject", "/P", pictures_);
    text += "/ExtGState << ";
    for (const int step : opacities_) {
        const std::string share = pdfNumber(static_cast<double>(step) / kOpacities);
        text += "/O" + std::to_string(step) + " << /CA " + share + " /ca " + share + " >> ";
    }
    return text + ">> >>";
}

void PdfPage::finish() {
    const auto listOf = [](const std::vector<int>& objects) {
        std::string text = "[ ";
        for (const int number : objects)
            text += pdfReference(number) + " ";
        return text + "]";
    };
    int profileNumber = 0;
    if (const auto profile = srgbProfile(); !profile.empty()) {
        profileNumber = file_.reserve();
        file_.beginStream(profileNumber, "/N 3 /Alternate /DeviceRGB");
        file_.streamBytes({reinterpret_cast<const char*>(profile.data()), profile.size()});
        file_.endStream();
    }
    const std::string fonts = fonts_.write(file_);
    const glm::dvec2 size = header_.paperMm * kPointsPerMm / unit_;
    file_.write(page_, "<< /Type /Page /Parent " + pdfReference(pages_) + " /MediaBox [0 0 " + pdfNumber(size.x) + " " +
                           pdfNumber(size.y) + "] /UserUnit " + pdfNumber(unit_) +
                           " /Group << /S /Transparency /CS /DeviceRGB >> /Resources " +
                           resources(profileNumber, fonts) + " /Contents " + listOf(contents_) + " >>");
    file_.write(pages_, "<< /Type /Pages /Count 1 /Kids [" + pdfReference(page_) + "] >>");
    const std::vector<int> topFirst(layers_.rbegin(), layers_.rend());
    file_.write(catalog_, "<< /Type /Catalog /Pages " + pdfReference(pages_) + " /OCProperties << /OCGs " +
                              listOf(layers_) + " /D << /Order " + listOf(topFirst) + " >> >> >>");
    file_.write(info_, "<< /Title " + pdfText(header_.title) + " /Subject " + pdfText(header_.description) +
                           " /Creator (Limner) >>");
    file_.finish(catalog_, info_);
}

} // namespace

std::unique_ptr<VectorPage> makePdfPage(const PageHeader& header, std::FILE* stream) {
    return std::make_unique<PdfPage>(header, stream);
}

} // namespace limner
