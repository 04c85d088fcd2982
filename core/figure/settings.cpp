#include "core/base/error.h"
#include "core/figure/description.h"

#include <algorithm>

namespace limner {

using description::Facts;
using description::Field;
using description::Findings;
using description::Place;
using description::Shape;
using description::ValueType;

namespace {

[[noreturn]] void refuse(const std::string& pointer, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::usage, {"cannot set the figure's parameter", pointer, why, remedy});
}

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

/// Takes one assignment to its place in a figure and carries it out.
class Assignment {
  public:
    explicit Assignment(const std::string& text) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) {
            refuse(text, "there is no value", "write /pointer=VALUE");
        }
        pointer_ = text.substr(0, equals);
        value_ = text.substr(equals + 1);
        if (!description::splitPointer(pointer_, tokens_) || tokens_.empty()) {
            refuse(pointer_, "it is not a JSON pointer", "write for example /camera/height_mm=200");
        }
        removes_ = value_.find_first_not_of(" \t") != std::string::npos && trimmed(value_) == "null";
    }

    /// Leaves the figure in any state when it throws.
    void apply(Figure& figure) {
        const Facts whole;
        place_ = {&description::figureType(), &figure, &whole, ""};
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            step(figure, i);
            if (done_) {
                return;
            }
        }
        if (!removes_) {
            assign(figure);
        } else if (!made_) {
            remove(figure);
        }
    }

    /// The assignment asked to remove something that is not there: nothing changes.
    [[nodiscard]] bool changesNothing() const { return removes_ && made_; }

  private:
    static std::string trimmed(const std::string& text) {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
    }

    void step(Figure& figure, std::size_t index) {
        openOptional();
        const std::string& token = tokens_[index];
        const std::string pointer = place_.pointer + "/" + description::escapedToken(token);
        container_ = place_;
        switch (place_.type->shape) {
        case Shape::object: stepIntoObject(figure, index, pointer); break;
        case Shape::list: stepIntoList(token); break;
        case Shape::tuple: stepIntoTuple(token); break;
        case Shape::names:
            name_ = &(*static_cast<std::map<std::string, std::string>*>(place_.value))[token];
            place_ = {&textType(), name_, place_.facts, pointer};
            break;
        default:
            refuse(pointer, place_.pointer + " has no parts",
                   "it is " + description::legalText(*place_.type, *place_.facts));
        }
    }

    static const ValueType& textType() { return *description::figureType().fields()[0].type; } // the title's

    void openOptional() {
        if (place_.type->shape == Shape::optional) {
            const bool absent = place_.type->count(place_.value) == 0;
            made_ = made_ || absent;
            place_.value = absent ? place_.type->append(place_.value) : place_.type->at(place_.value, 0);
            place_.type = place_.type->item;
        }
    }

    void stepIntoObject(Figure& figure, std::size_t index, const std::string& pointer) {
        const Field* field = findField(index);
        if (field == nullptr) {
            if (removes_ && index + 1 == tokens_.size() && figure.unknown.erase(pointer) > 0) {
                done_ = true;
                return;
            }
            const auto known = description::memberNames(*place_.type);
            const std::string nearest = description::nearestWord(tokens_[index], known);
            refuse(pointer, "there is no such parameter",
                   nearest.empty() ? "known here: " + join(known) : "did you mean \"" + nearest + "\"?");
        }
        member_ = field;
        place_ = {field->type, field->of(place_.value), &field->facts, pointer};
    }

    /// Of two members that share a name, the next token or the value tells which is meant.
    const Field* findField(std::size_t index) const {
        const bool last = index + 1 == tokens_.size();
        const std::size_t start = value_.find_first_not_of(" \t\r\n");
        const bool wantsObject =
            last ? start != std::string::npos && value_[start] == '{'
                 : tokens_[index + 1] != "-" && tokens_[index + 1].find_first_not_of("0123456789") != std::string::npos;
        for (const Field& field : place_.type->fields()) {
            const bool another = field.facts.sharesName && (field.type->shape == Shape::optional) != wantsObject;
            if (field.name != nullptr && tokens_[index] == field.name && !another) {
                return &field;
            }
        }
        return nullptr;
    }

    std::size_t listIndex(const std::string& token, std::size_t count) const {
        if (token == "-") {
            return count;
        }
        constexpr std::size_t kLongestIndex = 9; // digits: fits any integer
        if (token.empty() || token.size() > kLongestIndex ||
            token.find_first_not_of("0123456789") != std::string::npos) {
            refuse(place_.pointer + "/" + token, "a place in a list is a number from 0, or - to append",
                   "the list has " + std::to_string(count) + " items");
        }
        return std::stoul(token);
    }

    void stepIntoList(const std::string& token) {
        const std::size_t count = place_.type->count(place_.value);
        const std::size_t index = listIndex(token, count);
        if (index >= place_.facts->atMost) {
            refuse(place_.pointer + "/" + token, "the list is too long",
                   "it may have " + std::to_string(place_.facts->atMost) + " items");
        }
        index_ = index;
        if (removes_ && index >= count) {
            made_ = true;
        }
        for (std::size_t size = count; size <= index; ++size) {
            place_.type->append(place_.value);
        }
        place_.value = place_.type->at(place_.value, index);
        place_.type = place_.type->item;
        place_.pointer += "/" + std::to_string(index);
    }

    void stepIntoTuple(const std::string& token) {
        const std::size_t index = listIndex(token, place_.type->size);
        if (index >= place_.type->size) {
            refuse(place_.pointer + "/" + token, "there is no such component",
                   "the last one is " + std::to_string(place_.type->size - 1));
        }
        place_.value = place_.type->at(place_.value, index);
        place_.type = place_.type->item;
        place_.pointer += "/" + std::to_string(index);
    }

    void assign(Figure& figure) {
        forgetUnknown(figure, place_.pointer);
        // What is text stays text, though it may look like a number: --set /title=2024.
        const ValueType& type = place_.type->shape == Shape::optional ? *place_.type->item : *place_.type;
        const bool isText = type.shape == Shape::text || type.shape == Shape::word;
        const bool quotedText = trimmed(value_).starts_with('"');
        Findings findings;
        const bool isJson = (!isText || quotedText) && description::readText(place_, value_, findings);
        if (!isJson) {
            description::readText(place_, quotedJson(value_), findings);
        }
        if (!findings.problems.empty()) {
            const Problem& problem = findings.problems.front();
            refuse(problem.pointer, problem.fatal ? problem.why : "there is no such parameter", problem.mend);
        }
    }

    /// Plain text as a JSON string.
    static std::string quotedJson(const std::string& text) {
        std::string result = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\') {
                result += '\\';
                result += c;
            } else if (static_cast<unsigned char>(c) < 0x20) {
                constexpr char kDigits[] = "0123456789abcdef";
                result += "\\u00";
                result += kDigits[static_cast<unsigned char>(c) >> 4];
                result += kDigits[static_cast<unsigned char>(c) & 15];
            } else {
                result += c;
            }
        }
        return result + "\"";
    }

    /// `null`: takes an optional part or a list's item out, and puts anything else back to its default.
    void remove(Figure& figure) {
        forgetUnknown(figure, place_.pointer);
        const ValueType& container = *container_.type;
        if (place_.type->shape == Shape::optional) {
            place_.type->assign(place_.value, place_.type->defaults());
        } else if (container.shape == Shape::list) {
            container.erase(container_.value, index_);
            shiftUnknown(figure);
        } else if (container.shape == Shape::names) {
            static_cast<std::map<std::string, std::string>*>(container_.value)->erase(tokens_.back());
        } else if (container.shape == Shape::object) {
            place_.type->assign(place_.value, member_->of(container.defaults()));
        } else {
            refuse(place_.pointer, "a component cannot be removed",
                   "write " + description::legalText(*place_.type, *place_.facts));
        }
    }

    static void forgetUnknown(Figure& figure, const std::string& pointer) {
        std::erase_if(figure.unknown, [&](const auto& entry) { return entry.first.starts_with(pointer + "/"); });
    }

    /// Unknown members of the items behind a removed one move up with them.
    void shiftUnknown(Figure& figure) const {
        UnknownMembers shifted;
        const std::string list = container_.pointer + "/";
        for (const auto& [pointer, text] : figure.unknown) {
            const std::size_t end = pointer.find('/', list.size());
            const bool inside = pointer.starts_with(list) && end != std::string::npos;
            const std::size_t index = inside ? std::stoul(pointer.substr(list.size(), end - list.size())) : 0;
            const bool moves = inside && index > index_;
            shifted[moves ? list + std::to_string(index - 1) + pointer.substr(end) : pointer] = text;
        }
        figure.unknown = std::move(shifted);
    }

    std::string pointer_;
    std::string value_;
    std::vector<std::string> tokens_;
    bool removes_ = false;
    bool made_ = false; ///< something on the way was not there
    bool done_ = false;
    Place place_;
    Place container_; ///< of `place_`
    const Field* member_ = nullptr;
    std::size_t index_ = 0;
    std::string* name_ = nullptr;
};

/// Another path is another scan: what was loaded, and what was known of it, no longer holds.
void dropStale(const std::optional<VolumeReference>& before, std::optional<VolumeReference>& after) {
    if (!before || !after) {
        return;
    }
    const bool same = before->path == after->path && before->raw == after->raw && before->series == after->series;
    if (same) {
        return;
    }
    after->data = nullptr;
    if (after->sha256 == before->sha256) {
        after->sha256.clear();
    }
    if (after->absolutePath == before->absolutePath) {
        after->absolutePath.clear();
    }
    if (after->bytes == before->bytes) {
        after->bytes = 0;
    }
    if (after->path != before->path) {
        after->embedded = false;
    }
}

void dropStale(const Figure& before, Figure& after) {
    dropStale(before.volume, after.volume);
    dropStale(before.secondVolume, after.secondVolume);
    if (before.labels && after.labels && before.labels->path != after.labels->path) {
        after.labels->data = nullptr;
        if (after.labels->absolutePath == before.labels->absolutePath) {
            after.labels->absolutePath.clear();
        }
    }
    for (std::size_t i = 0; i < std::min(before.styles.size(), after.styles.size()); ++i) {
        const bool moved = before.styles.size() != after.styles.size();
        if (!moved && before.styles[i].file != after.styles[i].file) {
            after.styles[i].sphere = nullptr;
        }
        std::optional<StyleTexture>& texture = after.styles[i].texture;
        const std::optional<StyleTexture>& old = before.styles[i].texture;
        if (!moved && texture && (!old || old->file != texture->file)) {
            texture->tile = nullptr;
        }
    }
    if (before.background.file != after.background.file) {
        after.background.picture = nullptr;
    }
}

} // namespace

Figure withSetting(const Figure& figure, const std::string& assignment) {
    Figure changed = figure;
    Assignment step(assignment);
    step.apply(changed);
    if (step.changesNothing()) {
        return figure;
    }
    dropStale(figure, changed);
    return changed;
}

} // namespace limner
