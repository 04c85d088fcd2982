#include "widgets/artwork_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kRestMs = 150;       // a hand that zooms has stopped
constexpr double kZoomStep = 1.25; // per wheel click and key
constexpr double kLeastBrush = 2;  // logical pixels
constexpr double kLargestBrush = 120;
constexpr double kBrushStep = 1.2;

} // namespace

ArtworkCanvas::ArtworkCanvas(QWidget* parent) : QWidget(parent), tool_(makeArtworkTool(kind_, *this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Artwork"));
    setAccessibleDescription(tr("The scanned artwork. The wheel zooms, the middle button or Space moves it; arrow keys "
                                "move what is chosen, Delete removes it."));
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, &ArtworkCanvas::askForSharper);
}

ArtworkCanvas::~ArtworkCanvas() = default;

void ArtworkCanvas::setDraft(const ExtractionDraft& draft) {
    const bool otherPlate = draft.plate != draft_.plate;
    const bool otherRegion = draft.region != draft_.region;
    draft_ = draft;
    if (otherPlate) {
        things_.clear();
        sharper_ = {};
        if (draft_.plate) {
            view_.setSizes(size(), draft_.plate->size());
            view_.fit();
        }
        viewChanged();
    }
    if (otherRegion)
        regionBorder_.reset();
    update();
}

void ArtworkCanvas::setRoundThings(std::vector<RoundThing> things) {
    things_ = std::move(things);
    update();
}

void ArtworkCanvas::setSharper(const PlatePtr& plate, const ArtCut& cut, const QImage& picture) {
    if (plate != draft_.plate)
        return;
    const QSizeF size(picture.width() * cut.scale, picture.height() * cut.scale);
    sharper_ = {plate, QRectF(QPointF(cut.origin.x, cut.origin.y), size), picture};
    update();
}

void ArtworkCanvas::setTool(ToolKind kind) {
    if (kind == kind_)
        return;
    tool_->cancel();
    kind_ = kind;
    tool_ = makeArtworkTool(kind, *this);
    toolDown_ = false;
    showCursor();
    update();
}

void ArtworkCanvas::setOptions(const ToolOptions& options) {
    options_ = options;
    update();
}

void ArtworkCanvas::changeOptions(const ToolOptions& options) {
    if (options == options_)
        return;
    setOptions(options);
    Q_EMIT optionsChanged(options);
}

QString ArtworkCanvas::hint() const { return draft_.plate ? tool_->hint() : QString(); }

void ArtworkCanvas::fit() {
    view_.fit();
    viewChanged();
}

void ArtworkCanvas::showPixels() {
    view_.zoomTo(1 / devicePixelRatioF(), QRectF(rect()).center());
    viewChanged();
}

void ArtworkCanvas::zoomBy(double factor) {
    view_.zoomBy(factor, QRectF(rect()).center());
    viewChanged();
}

void ArtworkCanvas::removeChosen() { tool_->remove(); }

void ArtworkCanvas::viewChanged() {
    rest_.start(kRestMs);
    update();
    Q_EMIT zoomChanged();
}

void ArtworkCanvas::askForSharper() {
    if (!draft_.plate)
        return;
    const double pixels = view_.scale() * devicePixelRatioF(); // of the screen per artwork pixel
    const double reduction = draft_.plate->reduction();
    if (reduction <= 1 || pixels * reduction <= 1)
        return;
    const glm::dvec2 low = view_.toArtwork({0, 0});
    const glm::dvec2 high = view_.toArtwork({static_cast<double>(width()), static_cast<double>(height())});
    const QRect seen = QRectF(QPointF(low.x, low.y), QPointF(high.x, high.y)).toAlignedRect() &
                       QRect(QPoint(0, 0), draft_.plate->size());
    if (!seen.isEmpty())
        Q_EMIT sharperWanted(
            {seen.x(), seen.y(), seen.width(), seen.height()},
            static_cast<int>(std::ceil(std::max(seen.width(), seen.height()) * std::min(pixels, 1.0))));
}

void ArtworkCanvas::resizeEvent(QResizeEvent*) {
    view_.setSizes(size(), draft_.plate ? QSizeF(draft_.plate->size()) : QSizeF(1, 1));
    viewChanged();
}

ToolPointer ArtworkCanvas::pointerOf(const QMouseEvent& event) const {
    return {event.position(), view_.toArtwork(event.position()), event.modifiers()};
}

void ArtworkCanvas::showCursor() {
    setCursor(panning_ ? Qt::ClosedHandCursor
              : space_ ? Qt::OpenHandCursor
                       : (draft_.plate ? tool_->cursor() : Qt::ArrowCursor));
}

void ArtworkCanvas::mousePressEvent(QMouseEvent* event) {
    if (!draft_.plate || panning_ || toolDown_)
        return;
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && space_)) {
        panning_ = true;
        panFrom_ = event->position();
    } else if (event->button() == Qt::LeftButton) {
        toolDown_ = true;
        tool_->press(pointerOf(*event));
        update();
    } else if (event->button() == Qt::RightButton) {
        tool_->finish();
    }
    showCursor();
}

void ArtworkCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!draft_.plate)
        return;
    if (panning_) {
        view_.panBy(event->position() - std::exchange(panFrom_, event->position()));
        viewChanged();
    } else if (toolDown_) {
        tool_->drag(pointerOf(*event));
    } else {
        tool_->hover(pointerOf(*event));
    }
    showCursor();
}

void ArtworkCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (panning_ && (event->button() == Qt::MiddleButton || event->button() == Qt::LeftButton))
        panning_ = false;
    else if (event->button() == Qt::LeftButton && std::exchange(toolDown_, false))
        tool_->release(pointerOf(*event));
    showCursor();
    update();
}

void ArtworkCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // it stands for the second press
    if (event->button() == Qt::LeftButton)
        tool_->finish();
}

void ArtworkCanvas::wheelEvent(QWheelEvent* event) {
    if (!draft_.plate)
        return;
    constexpr double kClick = 120; // of Qt's wheel
    view_.zoomBy(std::pow(kZoomStep, event->angleDelta().y() / kClick), event->position());
    viewChanged();
    event->accept();
}

bool ArtworkCanvas::movesArrow(int key, bool far) {
    const double x = key == Qt::Key_Right ? 1 : key == Qt::Key_Left ? -1 : 0;
    const double y = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (x == 0 && y == 0)
        return false;
    constexpr double kFar = 10; // logical pixels
    constexpr double kPan = 40;
    if (!tool_->nudge(glm::dvec2(x, y) * ((far ? kFar : 1) / view_.scale()))) {
        view_.panBy(QPointF(-x, -y) * kPan);
        viewChanged();
    }
    return true;
}

void ArtworkCanvas::keyPressEvent(QKeyEvent* event) {
    if (!draft_.plate || movesArrow(event->key(), event->modifiers().testFlag(Qt::ShiftModifier)))
        return;
    const auto brush = [this](double factor) {
        ToolOptions changed = options_;
        changed.brushRadius = std::clamp(options_.brushRadius * factor, kLeastBrush, kLargestBrush);
        changeOptions(changed);
    };
    switch (event->key()) {
    case Qt::Key_Escape: tool_->cancel(); break; // the dialog stays open
    case Qt::Key_Delete:
    case Qt::Key_Backspace: tool_->remove(); break;
    case Qt::Key_Return:
    case Qt::Key_Enter: tool_->finish(); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(kZoomStep); break;
    case Qt::Key_Minus: zoomBy(1 / kZoomStep); break;
    case Qt::Key_BracketLeft: brush(1 / kBrushStep); break;
    case Qt::Key_BracketRight: brush(kBrushStep); break;
    case Qt::Key_Space: space_ = true; break;
    default: QWidget::keyPressEvent(event); return;
    }
    showCursor();
    update();
}

void ArtworkCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        space_ = false;
        showCursor();
    } else {
        QWidget::keyReleaseEvent(event);
    }
}

void ArtworkCanvas::focusInEvent(QFocusEvent*) { update(); }

void ArtworkCanvas::focusOutEvent(QFocusEvent*) {
    space_ = false;
    update();
}

void ArtworkCanvas::leaveEvent(QEvent*) { update(); }

} // namespace limner
