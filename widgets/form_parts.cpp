#include "widgets/form_parts.h"

#include "core/figure/figure.h"
#include "core/figure/parameters.h"
#include "widgets/core_words.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>
#include <cassert>

namespace limner {
namespace {

class WheelGuard : public QObject {
  public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

const Parameter& setting(std::string_view pointer) {
    const Parameter* parameter = findParameter(pointer);
    assert(parameter);
    return *parameter;
}

} // namespace

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

QFormLayout* formLayout(QWidget* parent) {
    auto* form = new QFormLayout(parent);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    return form;
}

QScrollArea* scrolling(QWidget* content) {
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    return scroll;
}

QLabel* addLabelled(QFormLayout* form, const QString& text, QWidget* field, QWidget* buddy) {
    buddy = buddy ? buddy : field;
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    label->setToolTip(buddy->toolTip());
    form->addRow(label, field);
    return label;
}

QToolButton* textButton(const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    return button;
}

void showWhenChosen(QToolButton* button) {
    button->setCheckable(true);
    const auto show = [button](bool chosen) {
        QPalette colours; // what is not set here is the application's
        if (chosen) {
            colours.setColor(QPalette::Button, QApplication::palette().color(QPalette::Highlight));
            colours.setColor(QPalette::ButtonText, QApplication::palette().color(QPalette::HighlightedText));
        }
        button->setPalette(colours);
    };
    QObject::connect(button, &QToolButton::toggled, button, show);
}

QComboBox* choiceBox(std::string_view pointer, const ChoiceWords& words) {
    auto* box = new QComboBox;
    for (const auto& [word, name] : words)
        box->addItem(name, QString(word));
    assert(std::ranges::equal(words, setting(pointer).choices, {}, [](const auto& pair) { return pair.first; }));
    box->setAccessibleName(labelOfSetting(pointer));
    box->setToolTip(helpOfSetting(pointer));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // long words must not widen the panel
    leaveWheelToPanel(box);
    return box;
}

void choose(QComboBox* box, const std::string& word) {
    box->setCurrentIndex(box->findData(QString::fromStdString(word)));
}

std::string chosenWord(const QComboBox* box) { return box->currentData().toString().toStdString(); }

void leaveWheelToPanel(QWidget* widget) {
    widget->setFocusPolicy(Qt::StrongFocus); // the wheel itself must not give the focus
    widget->installEventFilter(new WheelGuard(widget));
}

const Volume* scanOf(const Figure* figure) {
    return figure && figure->volume && figure->volume->data ? figure->volume->data.get() : nullptr;
}

QString labelOfSetting(std::string_view pointer) { return coreWord(setting(pointer).label); }

QString helpOfSetting(std::string_view pointer) { return coreWord(setting(pointer).help); }

} // namespace limner
