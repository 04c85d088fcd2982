#include "core/base/units.h"
#include "renderer/export/compact_text.h"
#include "renderer/export/memory_stream.h"
#include "renderer/export/picture_writer.h"
#include "renderer/export/svg_text.h"
#include "renderer/export/vector_page.h"

#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace limner {

namespace {

/// What marks share: written once, for all of a run.
struct Look {
    enum class Kind { dot, line, outline } kind;
    InkColour rgb{0};
    float widthMm = 0; ///< of lines
    friend bool operator==(const Look&, const Look&) = default;
};

/// An outline as path data.
class PathSink {
  public:
    explicit PathSink(CompactText& text) : text_(text) {}
    void moveTo(glm::vec2 place) { put('M', place); }
    void lineTo(glm::vec2 place) {
        if (rounded(place) != last_)
            put('L', place);
    }
    void arcTo(glm::vec2 centre, float radius, glm::vec2 /*from*/, glm::vec2 to) {
        const glm::vec2 end = centre + to * radius;
        if (rounded(end) == last_)
            return;
        text_ << 'A';
        text_.number(radius, 4) << ' ';
        text_.number(radius, 4) << " 0 0 0 ";
        place(end);
    }

  private:
    using Place = glm::vec<2, std::int64_t>;
    static Place rounded(glm::vec2 place) { return {micrometres(place.x), micrometres(place.y)}; }
    void put(char command, glm::vec2 at) {
        text_ << command;
        place(at);
    }
    void place(glm::vec2 at) {
        last_ = rounded(at);
        text_.fixed(last_.x, kPlaceDecimals) << ' ';
        text_.fixed(last_.y, kPlaceDecimals);
    }
    CompactText& text_;
    Place last_{0};
};

class SvgPage : public VectorPage {
  public:
    SvgPage(const PageHeader& header, std::FILE* stream)
        : header_(header),
          text_([stream](std::string_view piece) { std::fwrite(piece.data(), 1, piece.size(), stream); }) {
        text_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
                 "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"";
        size("mm\" height=\"", "mm\" viewBox=\"0 0 ");
        size(" ", "\">\n");
        text_ << "<title>" << escapedXml(header.title) << "</title>\n<desc>" << escapedXml(header.description)
              << "</desc>\n";
    }

    void beginLayer(const std::string& name) override {
        text_ << "<g id=\"layer";
        text_.fixed(++layers_, 0) << "\" inkscape:groupmode=\"layer\" inkscape:label=\"" << escapedXml(name) << "\">\n";
    }
    void endLayer() override {
        endRun();
        text_ << "</g>\n";
    }

    void fill(const glm::dvec3& rgb) override {
        const glm::dvec3 bytes = glm::clamp(rgb, 0.0, 1.0) * 255.0 + 0.5;
        text_ << "<rect width=\"";
        size("\" height=\"", "\" fill=\"");
        text_ << hexColour(InkColour(bytes)) << "\"/>\n";
    }

    void beginPicture(glm::ivec2 size, double dpi) override {
        PictureHeader picture;
        picture.layout.alpha = AlphaForm::unassociated;
        picture.size = size;
        picture.dpi = dpi;
        picture.name = header_.name;
        png_ = std::make_unique<MemoryStream>();
        writer_.emplace(picture, png_->stream());
    }
    void pictureRows(std::span<const std::byte> rgba, int rows) override { writer_->writeRows(rgba, rows); }
    void endPicture() override {
        writer_->finish();
        text_ << "<image width=\"";
        size("\" height=\"", "");
        endImage();
    }

    void dot(const Dot& dot) override {
        run({Look::Kind::dot, dot.rgb});
        text_ << "<circle cx=\"";
        text_.number(dot.placeMm.x, kPlaceDecimals) << "\" cy=\"";
        text_.number(dot.placeMm.y, kPlaceDecimals) << "\" r=\"";
        text_.number(dot.radiusMm, 4) << '"';
        end("fill-opacity", dot.opacity);
    }

    void line(std::span<const OutlinePoint> points, const Stroke& stroke) override {
        run({Look::Kind::line, stroke.rgb, 2 * points.front().radius});
        text_ << "<path d=\"M";
        std::int64_t x = micrometres(points.front().place.x);
        std::int64_t y = micrometres(points.front().place.y);
        text_.fixed(x, kPlaceDecimals) << ' ';
        text_.fixed(y, kPlaceDecimals) << 'l';
        for (const OutlinePoint& point : points.subspan(1)) {
            const std::int64_t dx = micrometres(point.place.x) - x; // from the rounded place: errors do not add up
            const std::int64_t dy = micrometres(point.place.y) - y;
            if (&point != &points[1])
                text_ << ' ';
            text_.fixed(dx, kPlaceDecimals) << (dy < 0 ? "" : " ");
            text_.fixed(dy, kPlaceDecimals);
            x += dx;
            y += dy;
        }
        text_ << '"';
        end("stroke-opacity", stroke.opacity);
    }

    void outline(std::span<const OutlinePoint> points, const Stroke& stroke) override {
        run({Look::Kind::outline, stroke.rgb});
        text_ << "<path d=\"";
        PathSink sink(text_);
        traceStroke(points, sink);
        text_ << "Z\"";
        end("fill-opacity", stroke.opacity);
    }

    void text(const PaperText& text) override {
        endRun();
        writeSvgText(text_, text);
    }

    void bar(const PaperBar& bar) override {
        endRun();
        text_ << "<rect x=\"";
        place(bar.box.lowMm, "\" y=\"", "\" width=\"");
        place(bar.box.sizeMm(), "\" height=\"", "\" fill=\"");
        text_ << hexColour(bar.rgb) << "\"/>\n";
    }

    void ball(const PaperBall& ball) override {
        if (!ball.sphere) {
            dot({glm::vec2(ball.centreMm), 0, static_cast<float>(ball.radiusMm), 1, ball.rgb});
            return;
        }
        endRun();
        const std::vector<std::uint8_t> rgba = ballBytes(*ball.sphere);
        beginPicture({kBallPixels, kBallPixels}, kBallPixels / (2 * ball.radiusMm) * kMmPerInch);
        pictureRows(std::as_bytes(std::span(rgba)), kBallPixels);
        writer_->finish();
        text_ << "<image x=\"";
        place(ball.centreMm - ball.radiusMm, "\" y=\"", "\" width=\"");
        place(glm::dvec2(2 * ball.radiusMm), "\" height=\"", "");
        endImage();
    }

    void finish() override {
        text_ << "</svg>\n";
        text_.flush();
    }

  private:
    /// The packed picture as the rest of an <image> element.
    void endImage() {
        text_ << "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,";
        constexpr std::size_t kPiece = 3 * 4096; // whole groups of three bytes: no padding between pieces
        const std::span<const std::byte> bytes = png_->bytes();
        for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
            const std::size_t count = std::min(kPiece, bytes.size() - at);
            text_ << OIIO::Strutil::base64_encode(
                OIIO::string_view(reinterpret_cast<const char*>(bytes.data()) + at, count));
        }
        text_ << "\"/>\n";
        writer_.reset();
        png_.reset();
    }
    void size(const char* between, const char* after) {
        text_.number(header_.paperMm.x, 6) << between;
        text_.number(header_.paperMm.y, 6) << after;
    }
    void place(const glm::dvec2& at, const char* between, const char* after) {
        text_.number(at.x, kPlaceDecimals) << between;
        text_.number(at.y, kPlaceDecimals) << after;
    }
    void end(const char* name, float opacity) {
        if (opacity < 1) {
            text_ << ' ' << name << "=\"";
            text_.number(opacity, 3) << '"';
        }
        text_ << "/>\n";
    }
    void run(const Look& look) {
        if (look_ == look)
            return;
        endRun();
        look_ = look;
        const std::string colour = hexColour(look.rgb);
        if (look.kind == Look::Kind::line) {
            text_ << "<g fill=\"none\" stroke=\"" << colour
                  << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke-width=\"";
            text_.number(look.widthMm, 4) << "\">\n";
        } else
            text_ << "<g fill=\"" << colour << "\">\n";
    }
    void endRun() {
        if (look_)
            text_ << "</g>\n";
        look_.reset();
    }

    PageHeader header_;
    CompactText text_;
    int layers_ = 0;
    std::optional<Look> look_;
    std::unique_ptr<MemoryStream> png_;
    std::optional<PictureWriter> writer_;
};

} // namespace

std::unique_ptr<VectorPage> makeSvgPage(const PageHeader& header, std::FILE* stream) {
    return std::make_unique<SvgPage>(header, stream);
}

} // namespace limner
