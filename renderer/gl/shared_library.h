#pragma once

#include <initializer_list>
#include <memory>
#include <string>

namespace limner::gl {

/// A library opened at run time, its names kept to itself.
class SharedLibrary {
  public:
    /// The first of the names that is there. Throws Error(noOpenGl) where none is.
    explicit SharedLibrary(std::initializer_list<const char*> names);
    /// The function of that name, or null.
    [[nodiscard]] void* find(const char* function) const;
    /// The same; throws Error(noOpenGl) where it is missing.
    template <typename Function>
    void require(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(required(name));
    }

  private:
    [[nodiscard]] void* required(const char* name) const;
    std::shared_ptr<void> handle_; // never closed: drivers leave threads and exit handlers behind
    std::string name_;
};

} // namespace limner::gl
