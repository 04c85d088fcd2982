#include "widgets/action_match.h"

#include <QStringList>

#include <algorithm>

namespace limner {
namespace {

constexpr double kWordStart = 100;
constexpr double kInside = 40;
constexpr double kLetters = 10;
constexpr double kPerLetter = 0.1; // a longer name is the worse of two that match alike

/// Lower case without accents: "Größe" is found by "grosse" and by "große".
QString folded(const QString& text) {
    QString result;
    for (const QChar c : text.toCaseFolded().normalized(QString::NormalizationForm_D))
        if (c.category() != QChar::Mark_NonSpacing)
            result += c;
    return result.replace(u"ß"_qs, "ss"); // case folding does it where the locale's rules are full
}

bool startsAWord(const QString& name, qsizetype at) { return at == 0 || !name[at - 1].isLetterOrNumber(); }

/// The letters in their order, with others between; the first one starts a word.
bool lettersInOrder(const QString& word, const QString& name) {
    for (qsizetype start = name.indexOf(word[0]); start >= 0; start = name.indexOf(word[0], start + 1)) {
        if (!startsAWord(name, start))
            continue;
        qsizetype at = start;
        qsizetype found = 1;
        while (found < word.size() && (at = name.indexOf(word[found], at + 1)) >= 0)
            ++found;
        if (found == word.size())
            return true;
    }
    return false;
}

double wordScore(const QString& word, const QString& name) {
    double best = 0;
    for (qsizetype at = name.indexOf(word); at >= 0; at = name.indexOf(word, at + 1))
        best = std::max(best, startsAWord(name, at) ? kWordStart : kInside);
    return best > 0 ? best : lettersInOrder(word, name) ? kLetters : 0;
}

} // namespace

std::optional<double> matchScore(const QString& typed, const QString& name) {
    const QString where = folded(name);
    double score = -kPerLetter * static_cast<double>(name.size());
    for (const QString& word : folded(typed).split(' ', Qt::SkipEmptyParts)) {
        const double one = wordScore(word, where);
        if (one <= 0)
            return std::nullopt;
        score += one;
    }
    return score;
}

} // namespace limner
