#pragma once

#include "core/base/error.h"
#include "core/style/style_library.h"
#include "widgets/job.h"
#include "widgets/style_source.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace limner {

/// The styles of the gallery: bundled ones and the user's library on disk. What is asked for is seen at once; the files
/// follow on a worker, one thing after the other. Lives on the interface's thread.
class StyleShelf : public QObject {
    Q_OBJECT

  public:
    explicit StyleShelf(std::filesystem::path folder, QObject* parent = nullptr);
    /// Finishes what is to be written.
    ~StyleShelf() override;

    void setBundled(const std::vector<Style>& styles);
    /// Reads the library again.
    void reload();
    /// The user's own and the bundled ones.
    [[nodiscard]] std::vector<GalleryItem> items() const;

    /// With its picture, read from the disk where it was not used lately; null, and `failed`, where that fails.
    std::shared_ptr<const Style> style(const std::string& key);
    /// What reads the same on any thread; throws Error.
    [[nodiscard]] std::function<std::shared_ptr<const Style>()> reader(const std::string& key) const;
    /// What a reader gave is at hand from now on.
    void keep(const std::string& key, std::shared_ptr<const Style> style);

    void setFavourite(const std::string& key, bool favourite);
    /// Of one of the user's own.
    void change(const StyleCard& card);
    /// Adds what `make` makes on a worker to the user's own: an import, a copy, a style from an artwork.
    void add(const QString& name, std::function<Style(Task&)> make);
    /// One that somebody else has added to the library.
    void takeIn(const Style& style);
    void remove(const std::string& id);
    /// Brings back what was removed last.
    void restore();
    [[nodiscard]] bool canRestore() const { return !removed_.empty(); }
    /// Whether files are read or written.
    [[nodiscard]] bool busy() const { return job_ || !waiting_.empty(); }

  Q_SIGNALS:
    void changed();
    void added(const QString& key);
    void removed(const QString& name);
    void problemsFound(const QStringList& lines);
    void failed(const limner::Error& error);

  private:
    struct Work {
        QString name;
        Job::Work work;
        std::function<void()> done = {};
        bool onlyReads = false; ///< of no use to a window that is gone
    };
    struct Removed {
        std::string id;
        QString name;
    };
    void enqueue(Work work);
    void next();
    void list(const StyleCard& card);
    void wantBalls();
    void changeSoon();

    StyleLibrary library_;
    std::vector<std::shared_ptr<const Style>> bundled_;
    std::vector<StyleCard> mine_;
    std::set<std::string> favourites_;    ///< ids; bundled ones by their key
    std::map<std::string, QImage> balls_; ///< by key
    std::set<std::string> ballsAsked_;
    std::deque<std::pair<std::string, std::shared_ptr<const Style>>> used_; ///< of the library, latest first
    std::vector<Removed> removed_;                                          ///< latest last
    std::deque<Work> waiting_;
    QPointer<Job> job_;
    QTimer soon_;
    bool closing_ = false;
};

} // namespace limner
