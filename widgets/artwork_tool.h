#pragma once

#include "core/style/extraction/find.h"
#include "widgets/artwork_view.h"
#include "widgets/extraction_draft.h"
#include "widgets/gesture_key.h"

#include <QCoreApplication>
#include <QPointF>

#include <memory>
#include <vector>

class QPainter;
class QPalette;

namespace limner {

enum class ToolKind { circle, ellipse, region, brush, normal, crease, open, ignore, picker };

/// How the tools work, chosen beside them.
struct ToolOptions {
    bool fromCentre = true;  ///< a circle is drawn from its middle, else from edge to edge
    bool findEdge = true;    ///< an outlined form is fitted to the picture, else taken as drawn
    double brushRadius = 14; ///< logical pixels of the screen
    SwatchRole role = SwatchRole::light;
    friend bool operator==(const ToolOptions&, const ToolOptions&) = default;
};

/// What an outline does to the form that there is.
enum class OutlineMode { replace, add, subtract };

/// What a tool is given of the canvas.
class ToolHost {
  public:
    virtual ~ToolHost() = default;
    [[nodiscard]] virtual const ExtractionDraft& draft() const = 0;
    [[nodiscard]] virtual const ArtworkView& view() const = 0;
    [[nodiscard]] virtual const std::vector<RoundThing>& roundThings() const = 0;
    [[nodiscard]] virtual const ToolOptions& options() const = 0;
    [[nodiscard]] virtual const QPalette& colours() const = 0;
    virtual void ask(const DraftEdit& edit) = 0;
    virtual void changeOptions(const ToolOptions& options) = 0;
    /// An outline that shall be fitted to the picture's edges.
    virtual void refine(const ArtPath& outline, OutlineMode mode) = 0;
    virtual void refresh() = 0; ///< paints the canvas anew
};

/// Where the pointer is.
struct ToolPointer {
    QPointF position;       ///< in the canvas
    glm::dvec2 place{0, 0}; ///< on the artwork
    Qt::KeyboardModifiers modifiers;
};

/// One tool of the artwork canvas: it turns the pointer's ways into edits of the draft. It keeps what is begun and what
/// is chosen, nothing else.
class ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(ArtworkTool)

  public:
    explicit ArtworkTool(ToolHost& host) : host_(host) {}
    virtual ~ArtworkTool() = default;
    ArtworkTool(const ArtworkTool&) = delete;
    ArtworkTool& operator=(const ArtworkTool&) = delete;

    virtual void press(const ToolPointer& pointer) = 0;
    virtual void drag(const ToolPointer& pointer) = 0; ///< the button is down
    virtual void release(const ToolPointer& pointer) = 0;
    virtual void hover(const ToolPointer&) {}
    /// A double click, Enter or the right button.
    virtual void finish() {}
    /// Gives up what is begun, else what is chosen.
    virtual void cancel() {}
    /// What is chosen moves by that many artwork pixels; false where nothing is.
    virtual bool nudge(glm::dvec2) { return false; }
    virtual void remove() {}
    virtual void paint(QPainter&) const {}
    [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }
    /// What to do next, one line.
    [[nodiscard]] virtual QString hint() const = 0;

  protected:
    [[nodiscard]] ToolHost& host() const { return host_; }
    [[nodiscard]] const ExtractionDraft& draft() const { return host_.draft(); }
    [[nodiscard]] QPointF toWidget(glm::dvec2 place) const { return host_.view().toWidget(place); }
    /// Logical pixels between a place and the pointer.
    [[nodiscard]] double away(glm::dvec2 place, const ToolPointer& pointer) const;

    /// A drag is one step: `begin` at its press, then `during` with the last one not ongoing. `again` is for keys.
    void begin(const char* name) { key_.begin(name_ = name); }
    void during(ExtractionDraft changed, const QString& label, bool ongoing);
    void again(const char* name, ExtractionDraft changed, const QString& label);
    void once(ExtractionDraft changed, const QString& label);

  private:
    ToolHost& host_;
    GestureKey key_;
    const char* name_ = "";
};

std::unique_ptr<ArtworkTool> makeArtworkTool(ToolKind kind, ToolHost& host);

} // namespace limner
