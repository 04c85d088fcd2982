#pragma once

#include "core/project/history.h"
#include "renderer/annotations.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QListWidget;
class QPlainTextEdit;
class QToolButton;

namespace limner {

class ColourButton;

/// What is written over the figure: a list, and the words and looks of the chosen one. Edits go out.
class AnnotationForm : public QWidget {
    Q_OBJECT

  public:
    explicit AnnotationForm(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    /// Where they stand in the picture: the list's tool tips say why one is not there.
    void setPlaces(const std::vector<AnnotationPlace>& places);
    [[nodiscard]] std::optional<std::size_t> selected() const;
    void select(std::optional<std::size_t> index);
    /// Chooses one and puts the cursor into its words, all of them marked.
    void writeWords(std::size_t index);
    /// One of any kind but a label, which needs a point; it is chosen then.
    void addKind(const std::string& kind);
    void removeSelected();

    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QToolButton* add() const { return add_; }
    [[nodiscard]] QToolButton* remove() const { return remove_; }
    [[nodiscard]] QComboBox* layoutChoice() const { return layout_; }
    [[nodiscard]] QPlainTextEdit* words() const { return words_; }
    [[nodiscard]] QDoubleSpinBox* size() const { return size_; }
    [[nodiscard]] QDoubleSpinBox* length() const { return length_; }
    [[nodiscard]] QComboBox* side() const { return side_; }
    [[nodiscard]] QCheckBox* placedByItself() const { return automatic_; }
    [[nodiscard]] QDoubleSpinBox* across() const { return across_; }
    [[nodiscard]] QDoubleSpinBox* down() const { return down_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void selectionChanged();
    void labelWanted();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void buildTop();
    QWidget* buildMarkup();
    void buildSettings();
    void connectSettings();
    QDoubleSpinBox* spin(double most, const QString& suffix, const QString& whenZero);
    void showChosen();
    /// Marks what is chosen in the words with a tag, or takes the tag away.
    void mark(const char* tag);
    void change(const QString& label, const std::string& key, const std::function<void(Annotation&)>& change);

    std::shared_ptr<const Figure> figure_;
    std::vector<AnnotationPlace> places_;
    QComboBox* layout_;
    QListWidget* list_;
    QToolButton* add_;
    QToolButton* remove_;
    QWidget* settings_;
    QFormLayout* rows_;
    QPlainTextEdit* words_;
    QDoubleSpinBox* size_;
    ColourButton* colour_;
    QCheckBox* ownColour_;
    QDoubleSpinBox* length_;
    QComboBox* side_;
    QCheckBox* automatic_;
    QDoubleSpinBox* across_;
    QDoubleSpinBox* down_;
    GestureKey key_;
};

} // namespace limner
