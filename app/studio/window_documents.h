#pragma once

#include "app/studio/workplace.h"
#include "core/base/file_lock.h"

#include <QObject>
#include <QStringList>

#include <filesystem>
#include <optional>

namespace limner {

class MissingBar;

/// What belongs to a project's file beside opening and saving it: who else has it open, going back to what was saved,
/// copies, packing the scan into it, and finding what is not where it was.
class WindowDocuments : public QObject {
    Q_OBJECT

  public:
    explicit WindowDocuments(const Workplace& place);

    [[nodiscard]] MissingBar& missing() { return *bar_; }
    /// The figure as it was saved, as a change that can be undone.
    void revert();
    void saveCopy(const std::filesystem::path& path);
    /// Whether the scan goes into the project, at the next save. Unpacked, it needs a file: `to` where it has none.
    void pack();
    void unpack(const std::filesystem::path& to);
    /// Looks for what is missing.
    void search();
    /// Takes what is missing first from there.
    void useFile(const std::filesystem::path& path);

  Q_SIGNALS:
    void reverted();
    void copySaved();
    void searched(bool found);

  private:
    void documentChanged();
    void hold();
    void showPacked();
    void packToggled(bool on);
    void showMissing();
    [[nodiscard]] QString missingName() const; ///< of what is missing first, without its folders
    void chooseFile();
    void chooseFolder();
    /// `file`: where the user says that the first missing part is; empty: everything is looked for.
    void bring(const std::filesystem::path& file);

    Workplace place_;
    MissingBar* bar_;
    std::optional<FileLock> lock_;
    std::filesystem::path held_; ///< of the lock, or of the try
    QPointer<Job> job_, searchJob_;
    unsigned generation_ = 0;
};

} // namespace limner
