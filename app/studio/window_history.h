#pragma once

#include "app/studio/workplace.h"

#include <QObject>

#include <memory>
#include <vector>

namespace limner {

class HistoryList;

/// The panel of the document's steps, and of states that the user gave a name: these are kept as long as the document
/// is open, whatever is undone or changed.
class WindowHistory : public QObject {
    Q_OBJECT

  public:
    explicit WindowHistory(const Workplace& place);
    [[nodiscard]] HistoryList& list() { return *list_; }
    void nameState(const QString& name);

  private:
    struct Named {
        QString name;
        std::shared_ptr<const Figure> figure;
    };
    void show();
    void showNames();
    void askName();
    void goToNamed(int place);

    Workplace place_;
    HistoryList* list_;
    std::vector<Named> named_;
    unsigned generation_ = 0;
};

} // namespace limner
