#pragma once

#include <QString>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

class QComboBox;
class QFormLayout;
class QLabel;
class QScrollArea;
class QToolButton;
class QWidget;

namespace limner {

class Volume;
struct Figure;

/// Small things that forms are made of, so that all look and behave alike.

/// A bold line above a group of rows.
QLabel* heading(const QString& text);

/// A form without margins, its rows close to each other.
QFormLayout* formLayout(QWidget* parent = nullptr);

/// A panel's content in a frameless area that scrolls up and down.
QScrollArea* scrolling(QWidget* content);

/// Adds a row whose label goes to `buddy` by its letter and has the buddy's tool tip; null: the field itself.
QLabel* addLabelled(QFormLayout* form, const QString& text, QWidget* field, QWidget* buddy = nullptr);

/// A small button with words.
QToolButton* textButton(const QString& text, const QString& tip);

/// A checkable button that is one of several choices: in the palette's highlight while it is the one.
void showWhenChosen(QToolButton* button);

/// A box of a setting's legal words, each as people read it; all of them, in the table's order.
using ChoiceWords = std::initializer_list<std::pair<const char*, QString>>;
QComboBox* choiceBox(std::string_view pointer, const ChoiceWords& words);
/// Shows the item that stands for a word, and the word of the chosen one.
void choose(QComboBox* box, const std::string& word);
std::string chosenWord(const QComboBox* box);

/// A wheel over the widget scrolls the panel and does not change the widget unless it has the focus.
void leaveWheelToPanel(QWidget* widget);

/// A figure's scan; null without a figure or a scan.
const Volume* scanOf(const Figure* figure);

/// Label and help of a setting in the parameter table; the pointer must exist.
QString labelOfSetting(std::string_view pointer);
QString helpOfSetting(std::string_view pointer);

} // namespace limner
