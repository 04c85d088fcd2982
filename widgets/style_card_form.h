#pragma once

#include "widgets/extraction_draft.h"
#include "widgets/gesture_key.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace limner {

/// Name, tags, credit and licence of the style that is being made, and what to do with it.
class StyleCardForm : public QWidget {
    Q_OBJECT

  public:
    explicit StyleCardForm(QWidget* parent = nullptr);

    void setDraft(const ExtractionDraft& draft);
    /// Whether there is a style to add, and a layer to put it on; `whyNot` is the second button's tip where there is
    /// none.
    void setPossible(bool add, const QString& whyNotUse);
    /// A line on what has been done.
    void say(const QString& line);
    [[nodiscard]] QLineEdit* name() const { return name_; }
    [[nodiscard]] QLineEdit* tags() const { return tags_; }
    [[nodiscard]] QLineEdit* credit() const { return credit_; }
    [[nodiscard]] QLineEdit* licence() const { return licence_; }
    [[nodiscard]] QPushButton* add() const { return add_; }
    [[nodiscard]] QPushButton* addAndUse() const { return addAndUse_; }
    [[nodiscard]] QPushButton* closeButton() const { return close_; }
    [[nodiscard]] QString said() const;

  Q_SIGNALS:
    void edited(const limner::DraftEdit& edit);

  private:
    void connectField(QLineEdit* field, std::string ExtractionDraft::*text);
    void showPossible();

    ExtractionDraft draft_;
    bool mayAdd_ = false;
    QString whyNotUse_;
    QLineEdit* name_;
    QLineEdit* tags_;
    QLineEdit* credit_;
    QLineEdit* licence_;
    QLabel* said_;
    QPushButton* add_;
    QPushButton* addAndUse_;
    QPushButton* close_;
    GestureKey key_;
};

} // namespace limner
