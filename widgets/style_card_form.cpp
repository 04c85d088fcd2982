#include "widgets/style_card_form.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace limner {
namespace {

QLineEdit* field(const QString& name, const QString& placeholder, const QString& tip) {
    auto* edit = new QLineEdit;
    edit->setAccessibleName(name);
    edit->setPlaceholderText(placeholder);
    edit->setToolTip(tip);
    constexpr int kLongest = 200; // a card's line
    edit->setMaxLength(kLongest);
    return edit;
}

} // namespace

StyleCardForm::StyleCardForm(QWidget* parent)
    : QWidget(parent), name_(field(tr("Name"), tr("Ivory bone"), tr("What the gallery calls the style"))),
      tags_(field(tr("Tags"), tr("bone, ink, warm"), tr("Words between commas, to find it by"))),
      credit_(field(tr("Credit"), tr("Who made the artwork"), tr("Named in figures that use the style"))),
      licence_(field(tr("Licence"), tr("Public domain, CC BY 4.0 …"), tr("What the artwork may be used for"))),
      said_(new QLabel), add_(new QPushButton(tr("&Add to my styles"))),
      addAndUse_(new QPushButton(tr("Add and &use"))), close_(new QPushButton(tr("Close"))) {
    auto* fields = new QGridLayout;
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setHorizontalSpacing(8);
    fields->setVerticalSpacing(4);
    const std::pair<QString, QLineEdit*> row[] = {
        {tr("&Name"), name_}, {tr("&Tags"), tags_}, {tr("C&redit"), credit_}, {tr("L&icence"), licence_}};
    int column = 0;
    for (const auto& [text, edit] : row) {
        auto* label = new QLabel(text);
        label->setBuddy(edit);
        fields->addWidget(label, 0, column);
        fields->addWidget(edit, 1, column);
        fields->setColumnStretch(column, 1);
        ++column;
    }
    said_->setAccessibleName(tr("What was done"));
    said_->setWordWrap(true);
    for (QPushButton* button : {add_, addAndUse_, close_})
        button->setAutoDefault(false); // Enter in a field is no command to add
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(8);
    buttons->addWidget(said_, 1);
    for (QPushButton* button : {add_, addAndUse_, close_})
        buttons->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addLayout(fields);
    layout->addLayout(buttons);
    connectField(name_, &ExtractionDraft::name);
    connectField(tags_, &ExtractionDraft::tags);
    connectField(credit_, &ExtractionDraft::credit);
    connectField(licence_, &ExtractionDraft::licence);
    setPossible(false, {});
}

void StyleCardForm::connectField(QLineEdit* edit, std::string ExtractionDraft::*text) {
    connect(edit, &QLineEdit::textEdited, this, [this, edit, text](const QString& typed) {
        ExtractionDraft changed = draft_;
        changed.*text = typed.toStdString();
        Q_EMIT edited(
            {std::move(changed), edit->accessibleName(), key_.again(edit->accessibleName().toStdString()), false});
    });
}

void StyleCardForm::setDraft(const ExtractionDraft& draft) {
    draft_ = draft;
    const std::pair<QLineEdit*, const std::string*> texts[] = {
        {name_, &draft.name}, {tags_, &draft.tags}, {credit_, &draft.credit}, {licence_, &draft.licence}};
    for (const auto& [edit, text] : texts) {
        const QString shown = QString::fromStdString(*text);
        if (edit->text() != shown) // the cursor stays where it is typed
            edit->setText(shown);
    }
    showPossible();
}

void StyleCardForm::setPossible(bool add, const QString& whyNotUse) {
    mayAdd_ = add;
    whyNotUse_ = whyNotUse;
    showPossible();
}

void StyleCardForm::showPossible() {
    const bool named = !QString::fromStdString(draft_.name).trimmed().isEmpty();
    add_->setEnabled(mayAdd_ && named);
    addAndUse_->setEnabled(mayAdd_ && named && whyNotUse_.isEmpty());
    const QString whyNot = !mayAdd_ ? tr("There is no style yet: draw a form on the artwork")
                           : named  ? QString()
                                    : tr("Give the style a name first");
    add_->setToolTip(whyNot.isEmpty() ? tr("Keeps the style with your own; the dialog stays open for the next")
                                      : whyNot);
    addAndUse_->setToolTip(!whyNot.isEmpty() ? whyNot
                           : !whyNotUse_.isEmpty()
                               ? whyNotUse_
                               : tr("Keeps the style and puts it on the chosen layer or style point"));
}

void StyleCardForm::say(const QString& line) { said_->setText(line); }

QString StyleCardForm::said() const { return said_->text(); }

} // namespace limner
