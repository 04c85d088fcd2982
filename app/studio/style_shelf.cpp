#include "app/studio/style_shelf.h"

#include "widgets/style_image.h"

#include <algorithm>
#include <utility>

namespace limner {
namespace {

constexpr std::size_t kKept = 16; ///< styles of the library at hand; one of 512 pixels takes some megabytes
constexpr int kSoonMs = 60;       ///< balls come one by one, the gallery takes them together

std::string favouriteId(const std::string& key) { return livesIn(key, StyleHome::mine) ? styleIdOf(key) : key; }

} // namespace

StyleShelf::StyleShelf(std::filesystem::path folder, QObject* parent) : QObject(parent), library_(std::move(folder)) {
    soon_.setSingleShot(true);
    soon_.setInterval(kSoonMs);
    connect(&soon_, &QTimer::timeout, this, &StyleShelf::changed);
}

StyleShelf::~StyleShelf() {
    closing_ = true;
    delete job_;
    Task task;
    for (const Work& work : waiting_) {
        try {
            if (!work.onlyReads)
                work.work(task);
        } catch (const Error&) { // nobody is left to be told
        }
    }
}

void StyleShelf::enqueue(Work work) {
    waiting_.push_back(std::move(work));
    if (!job_)
        next();
}

void StyleShelf::next() {
    if (waiting_.empty() || closing_)
        return;
    const Work work = std::move(waiting_.front());
    waiting_.pop_front();
    job_ = new Job(work.name, work.work, this);
    const auto end = [this, job = job_.data()] {
        job_.clear();
        job->deleteLater();
    };
    connect(job_, &Job::finished, this, [this, end, done = work.done] {
        end();
        if (done)
            done();
        if (!job_)
            next();
    });
    connect(job_, &Job::cancelled, this, end);
    connect(job_, &Job::failed, this, [this, end](const Error& error) {
        end();
        Q_EMIT failed(error);
        reload(); // what is shown was not written
        if (!job_)
            next();
    });
    job_->start();
}

void StyleShelf::setBundled(const std::vector<Style>& styles) {
    bundled_.clear();
    for (const Style& style : styles) {
        auto kept = std::make_shared<Style>(style);
        kept->file = "bundled:" + style.card.id;
        bundled_.push_back(std::move(kept));
    }
    wantBalls();
    Q_EMIT changed();
}

void StyleShelf::reload() {
    struct Read {
        StyleLibrary::Listing listing;
        std::set<std::string> favourites;
    };
    auto read = std::make_shared<Read>();
    const auto work = [read, library = library_](Task&) {
        read->listing = library.list();
        read->favourites = library.favourites();
    };
    enqueue({tr("Reading your styles"), work,
             [this, read] {
                 mine_ = read->listing.cards;
                 favourites_ = read->favourites;
                 used_.clear(); // their cards may have changed
                 wantBalls();
                 Q_EMIT changed();
                 QStringList lines;
                 for (const std::string& line : read->listing.problems)
                     lines << QString::fromStdString(line);
                 if (!lines.isEmpty())
                     Q_EMIT problemsFound(lines);
             },
             true});
}

void StyleShelf::wantBalls() {
    std::vector<std::pair<std::string, std::function<std::shared_ptr<const Style>()>>> readers;
    const auto want = [&](const std::string& key) {
        if (ballsAsked_.insert(key).second)
            readers.emplace_back(key, reader(key));
    };
    for (const StyleCard& card : mine_)
        want(styleKey(StyleHome::mine, card.id));
    for (const auto& style : bundled_)
        want(styleKey(StyleHome::bundled, style->card.id));
    if (readers.empty())
        return;
    enqueue({tr("Drawing styles"),
             [this, readers](Task& task) {
                 for (const auto& [key, read] : readers) {
                     task.throwIfCancelled();
                     QImage ball;
                     try {
                         ball = styleBall(*read()->sphere, kGalleryBallPixels);
                     } catch (const Error&) { // told when it is used
                         continue;
                     }
                     QMetaObject::invokeMethod(
                         this,
                         [this, key = key, ball] {
                             balls_[key] = ball;
                             changeSoon();
                         },
                         Qt::QueuedConnection);
                 }
             },
             {},
             true});
}

void StyleShelf::changeSoon() {
    if (!soon_.isActive())
        soon_.start();
}

std::vector<GalleryItem> StyleShelf::items() const {
    std::vector<GalleryItem> items;
    const auto add = [&](StyleHome home, const StyleCard& card, const std::string& file) {
        GalleryItem item{home, card, file, {}, false};
        const auto ball = balls_.find(item.key());
        if (ball != balls_.end())
            item.ball = ball->second;
        item.favourite = favourites_.contains(favouriteId(item.key()));
        items.push_back(std::move(item));
    };
    for (const StyleCard& card : mine_)
        add(StyleHome::mine, card, (library_.folder() / (card.id + ".png")).string());
    for (const auto& style : bundled_)
        add(StyleHome::bundled, style->card, style->file);
    return items;
}

std::function<std::shared_ptr<const Style>()> StyleShelf::reader(const std::string& key) const {
    const std::string id = styleIdOf(key);
    if (livesIn(key, StyleHome::mine)) {
        const auto kept = std::find_if(used_.begin(), used_.end(), [&](const auto& used) { return used.first == key; });
        if (kept != used_.end())
            return [style = kept->second] { return style; };
        return [id, library = library_] { return std::make_shared<const Style>(library.load(id)); };
    }
    const auto found =
        std::find_if(bundled_.begin(), bundled_.end(), [&](const auto& style) { return style->card.id == id; });
    const bool there = livesIn(key, StyleHome::bundled) && found != bundled_.end();
    return [style = there ? *found : std::shared_ptr<const Style>()] { return style; };
}

std::shared_ptr<const Style> StyleShelf::style(const std::string& key) {
    try {
        std::shared_ptr<const Style> style = reader(key)();
        keep(key, style);
        return style;
    } catch (const Error& error) {
        Q_EMIT failed(error);
        return nullptr;
    }
}

void StyleShelf::keep(const std::string& key, std::shared_ptr<const Style> style) {
    if (!style || !livesIn(key, StyleHome::mine))
        return;
    std::erase_if(used_, [&](const auto& used) { return used.first == key; });
    used_.emplace_front(key, std::move(style));
    if (used_.size() > kKept)
        used_.pop_back();
}

void StyleShelf::setFavourite(const std::string& key, bool favourite) {
    const std::string id = favouriteId(key);
    if (favourite)
        favourites_.insert(id);
    else
        favourites_.erase(id);
    Q_EMIT changed();
    enqueue({tr("Keeping favourites"), [=, library = library_](Task&) { library.setFavourite(id, favourite); }});
}

void StyleShelf::change(const StyleCard& card) {
    const auto own = std::find_if(mine_.begin(), mine_.end(), [&](const StyleCard& c) { return c.id == card.id; });
    if (own == mine_.end())
        return;
    *own = card;
    std::stable_sort(mine_.begin(), mine_.end(),
                     [](const StyleCard& a, const StyleCard& b) { return a.name < b.name; });
    const std::string key = styleKey(StyleHome::mine, card.id);
    std::erase_if(used_, [&](const auto& used) { return used.first == key; });
    Q_EMIT changed();
    enqueue({tr("Writing a style's card"), [card, library = library_](Task&) { library.change(card); }});
}

void StyleShelf::add(const QString& name, std::function<Style(Task&)> make) {
    auto written = std::make_shared<StyleCard>();
    enqueue({name,
             [written, make = std::move(make), library = library_](Task& task) { *written = library.add(make(task)); },
             [this, written] { list(*written); }});
}

void StyleShelf::takeIn(const Style& style) {
    list(style.card);
    keep(styleKey(StyleHome::mine, style.card.id), std::make_shared<const Style>(style));
}

void StyleShelf::list(const StyleCard& card) {
    const std::string key = styleKey(StyleHome::mine, card.id);
    balls_.erase(key); // of an earlier one of that id
    ballsAsked_.erase(key);
    std::erase_if(mine_, [&](const StyleCard& own) { return own.id == card.id; });
    mine_.push_back(card);
    std::stable_sort(mine_.begin(), mine_.end(),
                     [](const StyleCard& a, const StyleCard& b) { return a.name < b.name; });
    Q_EMIT changed();
    Q_EMIT added(QString::fromStdString(key));
    wantBalls();
}

void StyleShelf::remove(const std::string& id) {
    const auto own = std::find_if(mine_.begin(), mine_.end(), [&](const StyleCard& c) { return c.id == id; });
    if (own == mine_.end())
        return;
    const QString name = QString::fromStdString(own->name);
    removed_.push_back({id, name});
    mine_.erase(own);
    Q_EMIT changed();
    enqueue({tr("Removing a style"), [id, library = library_](Task&) { library.remove(id); }});
    Q_EMIT removed(name);
}

void StyleShelf::restore() {
    if (removed_.empty())
        return;
    const std::string id = removed_.back().id;
    removed_.pop_back();
    enqueue({tr("Bringing a style back"), [id, library = library_](Task&) { library.restore(id); },
             [this, id] {
                 ballsAsked_.erase(styleKey(StyleHome::mine, id));
                 reload();
             }});
}

} // namespace limner
