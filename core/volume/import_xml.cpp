#include "core/volume/import_xml.h"

#include <expat.h>

#include <exception>
#include <memory>
#include <new>
#include <type_traits>

namespace limner::importing {

namespace {

struct State {
    const XmlHandler* handler = nullptr;
    XML_Parser parser = nullptr;
    std::size_t depth = 0;
    bool refused = false;
    std::exception_ptr thrown;
};

/// Runs a handler's function; an exception must not pass through expat's C code.
template <typename F>
void guarded(State& state, F&& f) {
    if (state.refused || state.thrown) {
        return;
    }
    try {
        f();
    } catch (...) {
        state.thrown = std::current_exception();
        XML_StopParser(state.parser, XML_FALSE);
    }
}

void onStart(void* data, const XML_Char* name, const XML_Char** attributes) {
    State& state = *static_cast<State*>(data);
    if (++state.depth > state.handler->deepest) {
        state.refused = true;
        XML_StopParser(state.parser, XML_FALSE);
        return;
    }
    guarded(state, [&] {
        XmlElement element{name, {}};
        for (; attributes[0] != nullptr; attributes += 2) {
            element.attributes.emplace_back(attributes[0], attributes[1]);
        }
        if (state.handler->started) {
            state.handler->started(element);
        }
    });
}

void onEnd(void* data, const XML_Char* name) {
    State& state = *static_cast<State*>(data);
    --state.depth;
    guarded(state, [&] {
        if (state.handler->ended) {
            state.handler->ended(name);
        }
    });
}

void onText(void* data, const XML_Char* text, int length) {
    State& state = *static_cast<State*>(data);
    guarded(state, [&] {
        if (state.handler->text) {
            state.handler->text({text, static_cast<std::size_t>(length)});
        }
    });
}

void onEntity(void* data, const XML_Char*, int, const XML_Char*, int, const XML_Char*, const XML_Char*, const XML_Char*,
              const XML_Char*) {
    State& state = *static_cast<State*>(data);
    state.refused = true;
    XML_StopParser(state.parser, XML_FALSE);
}

} // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
    for (const auto& [name_, value] : attributes) {
        if (name_ == key) {
            return value;
        }
    }
    return {};
}

bool parseXml(std::string_view document, const XmlHandler& handler) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
        XML_ParserCreate(nullptr), &XML_ParserFree);
    if (parser == nullptr) {
        throw std::bad_alloc();
    }
    State state{&handler, parser.get(), 0, false, nullptr};
    XML_SetUserData(parser.get(), &state);
    XML_SetElementHandler(parser.get(), onStart, onEnd);
    XML_SetCharacterDataHandler(parser.get(), onText);
    XML_SetEntityDeclHandler(parser.get(), onEntity);
    bool sound = true;
    constexpr std::size_t kPiece = 1 << 20; // expat counts in int
    do {
        const std::string_view piece = document.substr(0, kPiece);
        document.remove_prefix(piece.size());
        sound = XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), document.empty() ? 1 : 0) ==
                XML_STATUS_OK;
    } while (sound && !document.empty());
    if (state.thrown) {
        std::rethrow_exception(state.thrown);
    }
    return sound && !state.refused;
}

} // namespace limner::importing
