#pragma once

#include "app/studio/workplace.h"
#include "core/project/look_library.h"

#include <QObject>

#include <filesystem>
#include <vector>

class QMenu;

namespace limner {

class VariantDialog;

/// Looks of the user's own, kept with a picture of their scan and laid over others; and sheets of variants.
class WindowLooks : public QObject {
    Q_OBJECT

  public:
    /// `thumbnail`: PNG of the shown picture, empty without one.
    WindowLooks(const Workplace& place, std::function<std::vector<std::byte>()> thumbnail);

    /// Each is a job; `changed` follows when the list is read anew, `used` when the figure has the look.
    void keep(const QString& name);
    void import(const std::filesystem::path& file);
    void use(const std::string& id, const QString& name);
    void remove(const std::string& id);
    [[nodiscard]] const std::vector<LookCard>& cards() const { return cards_; }
    VariantDialog* showVariants(); ///< deletes itself

  Q_SIGNALS:
    void changed();
    void used();

  private:
    void read();
    void showCards();
    void enable();

    Workplace place_;
    std::function<std::vector<std::byte>()> thumbnail_;
    LookLibrary library_;
    std::vector<LookCard> cards_;
    QMenu* mine_;
    QMenu* removal_;
    QPointer<Job> writeJob_, readJob_, useJob_;
};

} // namespace limner
