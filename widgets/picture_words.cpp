#include "widgets/picture_words.h"

#include "widgets/picture_feed.h"

#include <QLocale>

namespace limner {
namespace {

/// A sentence of the core as people write it.
QString sentence(const std::string& text) {
    const QString words = QString::fromStdString(text);
    return words.left(1).toUpper() + words.mid(1);
}

QString backendWord(const std::string& backend) {
    return backend == "gl" ? PictureWords::tr("OpenGL") : PictureWords::tr("processor");
}

} // namespace

PictureWords::PictureWords(QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setAccessibleName(tr("What the picture is"));
    connect(this, &QToolButton::clicked, this, [this] { Q_EMIT warningsWanted(warnings()); });
    display();
}

void PictureWords::showPicture(const ScreenPicture& picture) {
    const PictureFacts& facts = picture.facts;
    facts_ = tr("%1 · %2 × %3 · %4 ms · %5 M samples · %6")
                 .arg(backendWord(facts.backend))
                 .arg(picture.image.width())
                 .arg(picture.image.height())
                 .arg(facts.renderMs, 0, 'f', 0)
                 .arg(QLocale().toString(static_cast<double>(facts.samples) * 1e-6, 'f', 1),
                      facts.final ? tr("final") : tr("draft"));
    if (facts.final) { // a draft's are not known: those of before hold until the picture rests
        pictureWords_.clear();
        for (const std::string& warning : facts.warnings)
            pictureWords_ << sentence(warning);
    }
    display();
}

void PictureWords::setScanWords(const QStringList& words) {
    scanWords_ = words;
    display();
}

void PictureWords::clear() {
    facts_.clear();
    pictureWords_.clear();
    display();
}

void PictureWords::display() {
    const QStringList known = warnings();
    setVisible(!facts_.isEmpty());
    setText(known.isEmpty() ? facts_ : tr("%1 · %2 to know").arg(facts_).arg(known.size()));
    QString tip = tr("Backend, pixels, time and samples of the shown picture");
    for (const QString& line : known)
        tip += "\n• " + line;
    if (!known.isEmpty())
        tip += "\n" + tr("Press to read it above the picture");
    setToolTip(tip);
}

} // namespace limner
