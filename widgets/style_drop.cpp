#include "widgets/style_drop.h"

#include "core/figure/layer_edits.h"
#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"
#include "widgets/job.h"
#include "widgets/sheet_painting.h"
#include "widgets/style_mime.h"
#include "widgets/style_pictures.h"
#include "widgets/transfer_canvas.h"
#include "widgets/viewport.h"

#include <QCoreApplication>
#include <QDragMoveEvent>
#include <QEventLoop>
#include <QMimeData>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace limner {
namespace {

constexpr int kRestMs = 500;                ///< a hand that waits to see
const QColor kVeilColour(0x1f, 0x74, 0xd6); ///< no tissue and no usual ink has it

/// Label of a cell of a grid over labels; nothing where the grid is over something else.
std::optional<int> labelOfCell(const Transfer& transfer, std::size_t cell) {
    if (!secondAxis(transfer) || !transfer.grid)
        return std::nullopt;
    const std::size_t columns = std::max<std::size_t>(1, transfer.grid->x.size());
    const bool first = firstAxis(transfer) == TransferAxis::label;
    if (!first && *secondAxis(transfer) != TransferAxis::label)
        return std::nullopt;
    const auto& positions = first ? transfer.grid->x : transfer.grid->y;
    const std::size_t place = first ? cell % columns : cell / columns;
    return place < positions.size() ? std::optional(static_cast<int>(std::lround(positions[place]))) : std::nullopt;
}

QString labelName(const Figure& figure, int label) {
    if (label < 0)
        return StyleDrop::tr("other labels");
    if (figure.labels) {
        const auto named = figure.labels->names.find(std::to_string(label));
        if (named != figure.labels->names.end())
            return QString::fromStdString(named->second);
    }
    return StyleDrop::tr("label %1").arg(label);
}

} // namespace

QString targetWords(const Figure& figure, const StyleTarget& target) {
    const Layer& layer = figure.layers[target.layer];
    const QString name = QString::fromStdString(layer.name);
    if (!target.node || styleNodes(layer.transfer) < 2)
        return name;
    if (const auto label = labelOfCell(layer.transfer, *target.node))
        return StyleDrop::tr("%1 · %2").arg(name, labelName(figure, *label));
    const Volume* scan = figure.volume ? figure.volume->data.get() : nullptr;
    const double width = scan ? scan->range().high - scan->range().low : 1;
    const QString unit = scan ? QString::fromStdString(scan->contents().unit) : QString();
    const double step = std::pow(10.0, std::floor(std::log10(std::max(width, 1e-9) / 100))); // a hundredth, roundly
    const QString value = valueText(std::round(target.value / step) * step, step);
    return StyleDrop::tr("%1 · around %2").arg(name, unit.isEmpty() ? value : value + " " + unit);
}

StyleDrop::StyleDrop(Viewport* viewport)
    : QWidget(viewport), viewport_(viewport), pictures_(std::make_shared<StylePictures>()) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setAccessibleName(tr("Where a dragged style would go"));
    viewport->setAcceptDrops(true);
    viewport->installEventFilter(this);
    rest_.setSingleShot(true);
    rest_.setInterval(kRestMs);
    connect(&rest_, &QTimer::timeout, this, [this] {
        previewed_ = dropped();
        if (previewed_)
            Q_EMIT previewWanted(previewed_);
    });
    hide();
}

StyleDrop::~StyleDrop() {
    delete ray_;
    delete veilJob_;
}

void StyleDrop::setFigure(std::shared_ptr<const Figure> figure) {
    const auto scanOf = [](const std::shared_ptr<const Figure>& f) {
        return f && f->volume ? f->volume->data : nullptr;
    };
    if (scanOf(figure) != scanOf(figure_)) {
        leave();
        pictures_ = std::make_shared<StylePictures>(); // what it keeps is of the other scan
    }
    figure_ = std::move(figure);
}

std::optional<glm::dvec2> StyleDrop::pixelAt(QPointF position) const {
    if (!plan_ || !viewport_->sheet().contains(position))
        return std::nullopt;
    return viewport_->onFigure(position) * glm::dvec2(plan_->size);
}

bool StyleDrop::isMeant(const StyleTarget& target) const {
    if (!figure_ || !plan_ || !mayChange(*figure_, target.layer) || target.layer >= plan_->figure->layers.size())
        return false;
    const Layer& layer = figure_->layers[target.layer];
    return layer.name == plan_->figure->layers[target.layer].name &&
           (!target.node || *target.node < styleNodes(layer.transfer));
}

std::optional<StyleTarget> StyleDrop::meant() const {
    std::optional<StyleTarget> target = target_;
    if (target && whole_)
        target->node.reset();
    return target;
}

std::shared_ptr<const Figure> StyleDrop::dropped() const {
    const auto target = meant();
    if (!target || !style_ || !isMeant(*target))
        return nullptr;
    return std::make_shared<const Figure>(withStyle(*figure_, target->layer, target->node, *style_));
}

QString StyleDrop::words() const {
    const auto target = meant();
    if (!style_)
        return {};
    if (!target)
        return decided_ ? tr("Nothing here to put a style onto") : QString();
    if (!isMeant(*target))
        return tr("%1 is locked").arg(QString::fromStdString(plan_->figure->layers[target->layer].name));
    const QString style = QString::fromStdString(style_->card.name);
    const bool several = styleNodes(figure_->layers[target->layer].transfer) > 1;
    const QString where = targetWords(*figure_, *target);
    return several && whole_ ? tr("All of %1 → %2").arg(where, style)
           : several         ? tr("%1 → %2   (Shift: the whole layer)").arg(where, style)
                             : tr("%1 → %2").arg(where, style);
}

bool StyleDrop::enter(QDragMoveEvent* event) {
    if (!event->mimeData()->hasFormat(kStyleMime))
        return false;
    const auto& picture = viewport_->picture();
    style_ = source_ && figure_ && picture ? source_(event->mimeData()->data(kStyleMime).toStdString()) : nullptr;
    if (!style_)
        return false;
    if (plan_ != picture->plan) {
        plan_ = picture->plan;
        veils_.clear();
    }
    setGeometry(viewport_->rect());
    show();
    raise();
    move(*event);
    event->acceptProposedAction();
    return true;
}

void StyleDrop::move(const QDragMoveEvent& event) {
    whole_ = event.modifiers() & Qt::ShiftModifier;
    at_ = event.position();
    decide();
    follow();
}

void StyleDrop::decide() {
    if (ray_)
        return; // its end looks where the pointer is by then
    const auto pixel = pixelAt(at_);
    if (!pixel) {
        decided_ = at_;
        target_.reset();
        return;
    }
    auto found = std::make_shared<std::optional<StyleTarget>>();
    ray_ = new Job(
        tr("Looking at the picture"), [found, pixel, plan = plan_](Task&) { *found = styleTarget(*plan, *pixel); },
        this);
    connect(ray_, &Job::finished, this, [this, found, job = ray_.data(), place = at_] {
        ray_.clear();
        job->deleteLater();
        if (!style_)
            return;
        decided_ = place;
        target_ = *found;
        follow();
        if (place != at_)
            decide();
    });
    ray_->start();
}

void StyleDrop::follow() {
    update();
    const auto target = meant();
    const auto part = target ? std::optional(Part{target->layer, target->node}) : std::nullopt;
    if (part == part_)
        return;
    part_ = part;
    takePreviewBack();
    findVeil();
    if (part)
        rest_.start();
    else
        rest_.stop();
}

void StyleDrop::takePreviewBack() {
    if (std::exchange(previewed_, nullptr))
        Q_EMIT previewWanted(nullptr);
}

void StyleDrop::findVeil() {
    veil_ = {};
    if (!part_ || veilJob_)
        return;
    if (const auto kept = veils_.find(*part_); kept != veils_.end()) {
        veil_ = kept->second;
        update();
        return;
    }
    auto made = std::make_shared<QImage>();
    StyleTarget target = *target_;
    std::tie(target.layer, target.node) = *part_;
    veilJob_ = new Job(
        tr("Finding what is meant"),
        [made, target, plan = plan_, pictures = pictures_](Task& task) {
            *made = pictures->reach(*plan, target, kVeilColour, task);
        },
        this);
    const auto end = [this, made, part = *part_, job = veilJob_.data(), plan = plan_] {
        veilJob_.clear();
        job->deleteLater();
        if (plan == plan_)
            veils_[part] = *made;
        if (style_)
            findVeil(); // of what is meant by now
        update();
    };
    connect(veilJob_, &Job::finished, this, end);
    connect(veilJob_, &Job::failed, this, end); // no veil then; the word beside the pointer stays
    veilJob_->start();
}

void StyleDrop::drop(QDropEvent* event) {
    whole_ = event->modifiers() & Qt::ShiftModifier;
    at_ = event->position();
    if (decided_ != at_) { // the drop means what lies under it, not under where the pointer was
        const auto pixel = pixelAt(at_);
        target_ = pixel ? styleTarget(*plan_, *pixel) : std::nullopt;
    }
    const std::shared_ptr<const Figure> figure = dropped();
    const bool seen = figure && std::exchange(previewed_, nullptr); // what was seen is what comes
    if (figure)
        event->acceptProposedAction();
    leave();
    if (figure)
        Q_EMIT edited({*figure, tr("Replace style").toStdString(), {}, false});
    if (seen)
        Q_EMIT previewWanted(nullptr);
}

void StyleDrop::leave() {
    rest_.stop();
    style_.reset();
    target_.reset();
    part_.reset();
    decided_.reset();
    whole_ = false;
    veil_ = {};
    hide();
    takePreviewBack();
}

void StyleDrop::waitIdle() {
    while (ray_ || veilJob_)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

bool StyleDrop::eventFilter(QObject* watched, QEvent* event) {
    if (watched != viewport_)
        return false;
    switch (event->type()) {
    case QEvent::Resize: setGeometry(viewport_->rect()); return false;
    case QEvent::DragEnter: return enter(static_cast<QDragMoveEvent*>(event));
    case QEvent::DragMove:
        if (!style_)
            return false;
        move(*static_cast<QDragMoveEvent*>(event));
        static_cast<QDragMoveEvent*>(event)->acceptProposedAction();
        return true;
    case QEvent::DragLeave: leave(); return false;
    case QEvent::Drop:
        if (!style_)
            return false;
        drop(static_cast<QDropEvent*>(event));
        return true;
    default: return false;
    }
}

void StyleDrop::paintEvent(QPaintEvent*) {
    if (!style_)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const auto& picture = viewport_->picture();
    const bool previewShown = previewed_ && picture && picture->plan->figure->layers == previewed_->layers &&
                              picture->plan->figure->styles == previewed_->styles;
    if (!veil_.isNull() && !previewShown)
        painter.drawImage(viewport_->sheet(), veil_);
    const QString text = words();
    if (text.isEmpty())
        return;
    const QFontMetricsF metrics(font());
    const QSizeF size(metrics.horizontalAdvance(text) + 16, metrics.height() + 8);
    QRectF plate(at_ + QPointF(14, 18), size);
    const QRectF room = QRectF(rect()).adjusted(4, 4, -4, -4);
    plate.moveLeft(std::max(room.left(), std::min(plate.left(), room.right() - plate.width())));
    if (plate.bottom() > room.bottom())
        plate.moveBottom(at_.y() - 12);
    drawBadge(painter, plate, text);
}

} // namespace limner
