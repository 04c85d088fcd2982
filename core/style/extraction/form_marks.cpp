#include "core/base/error.h"
#include "core/style/extraction/forms.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>

namespace limner {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Strokes by hand are a few kilobytes; a file past this is something else.
constexpr std::uintmax_t kLargestFile = 16U << 20U;

/// Reads values and knows, for messages, where it is.
class MarksReader {
  public:
    explicit MarksReader(const fs::path& file) : file_(file) {}

    [[noreturn]] void fail(const std::string& place, const std::string& why) const {
        const std::string where = place.empty() ? file_.string() : file_.string() + ": " + place;
        throw Error(ErrorKind::badInput, {"cannot read the marks", where, why, "mend the file or mark anew"});
    }

    FormMarks marks(const Json& json) const {
        members(json, "", {"normals", "creases", "open", "depth"});
        FormMarks marks;
        each(json, "normals", [&](const Json& mark, const std::string& place) {
            members(mark, place, {"at", "normal"});
            NormalMark read{pointOf(required(mark, place, "at"), place + "/at"),
                            pointOf(required(mark, place, "normal"), place + "/normal")};
            constexpr double kRounded = 1e-3;
            const double length = std::hypot(read.normal.x, read.normal.y);
            if (length > 1 + kRounded) {
                fail(place + "/normal", "x and y of a normal lie in the unit disk");
            }
            read.normal /= std::max(1.0, length);
            marks.normals.push_back(read);
        });
        each(json, "creases", [&](const Json& crease, const std::string& place) {
            members(crease, place, {"path", "tilt_deg"});
            Crease read{pathOf(required(crease, place, "path"), place + "/path")};
            if (crease.contains("tilt_deg")) {
                read.tiltDegrees = numberOf(crease["tilt_deg"], place + "/tilt_deg");
            }
            if (std::abs(read.tiltDegrees) > 90) {
                fail(place + "/tilt_deg", "a crease's sides are tilted by at most 90 degrees");
            }
            marks.creases.push_back(read);
        });
        each(json, "open",
             [&](const Json& path, const std::string& place) { marks.open.push_back(pathOf(path, place)); });
        if (json.contains("depth")) {
            marks.depth = numberOf(json["depth"], "/depth");
            if (!(marks.depth >= 0.1 && marks.depth <= 10)) {
                fail("/depth", "a form's depth is 0.1 to 10 times its width");
            }
        }
        return marks;
    }

  private:
    void members(const Json& json, const std::string& place, std::initializer_list<const char*> known) const {
        if (!json.is_object()) {
            fail(place, "expected an object");
        }
        for (const auto& [name, value] : json.items()) {
            if (std::none_of(known.begin(), known.end(), [&](const char* one) { return name == one; })) {
                fail(place + "/" + name, "there is no such member");
            }
        }
    }

    const Json& required(const Json& json, const std::string& place, const char* name) const {
        if (!json.contains(name)) {
            fail(place, std::string("\"") + name + "\" is missing");
        }
        return json[name];
    }

    template <typename Take>
    void each(const Json& json, const char* name, const Take& take) const {
        if (!json.contains(name)) {
            return;
        }
        const std::string place = std::string("/") + name;
        if (!json[name].is_array()) {
            fail(place, "expected a list");
        }
        for (std::size_t i = 0; i < json[name].size(); ++i) {
            take(json[name][i], place + "/" + std::to_string(i));
        }
    }

    double numberOf(const Json& json, const std::string& place) const {
        const double value = json.is_number() ? json.get<double>() : NAN;
        if (!std::isfinite(value)) {
            fail(place, "expected a number");
        }
        return value;
    }

    glm::dvec2 pointOf(const Json& json, const std::string& place) const {
        if (!json.is_array() || json.size() != 2) {
            fail(place, "expected two numbers");
        }
        return {numberOf(json[0], place + "/0"), numberOf(json[1], place + "/1")};
    }

    ArtPath pathOf(const Json& json, const std::string& place) const {
        if (!json.is_array() || json.size() < 2) {
            fail(place, "expected a list of two points or more");
        }
        ArtPath path;
        for (std::size_t i = 0; i < json.size(); ++i) {
            path.push_back(pointOf(json[i], place + "/" + std::to_string(i)));
        }
        return path;
    }

    const fs::path& file_;
};

} // namespace

FormMarks loadFormMarks(const fs::path& file) {
    const MarksReader reader(file);
    std::error_code unknown;
    const auto size = fs::file_size(file, unknown);
    std::ifstream stream(file, std::ios::binary);
    if (unknown || !stream) {
        reader.fail("", "there is no such file");
    }
    if (size > kLargestFile) {
        reader.fail("", "marks are a small JSON file");
    }
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::exception& problem) {
        reader.fail("", problem.what());
    }
    return reader.marks(json);
}

} // namespace limner
