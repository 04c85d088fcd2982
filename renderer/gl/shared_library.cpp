#include "renderer/gl/shared_library.h"

#include "core/base/error.h"

#include <dlfcn.h>

namespace limner::gl {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names) : name_(*names.begin()) {
    void* handle = nullptr;
    for (const char* name : names) {
        handle = handle != nullptr ? handle : dlopen(name, RTLD_NOW | RTLD_LOCAL);
    }
    if (handle == nullptr) {
        throw Error(ErrorKind::noOpenGl,
                    {"OpenGL cannot be used", "", name_ + " is not installed", "install it, or use the backend cpu"});
    }
    handle_ = std::shared_ptr<void>(handle, [](void*) {});
}

void* SharedLibrary::find(const char* function) const { return dlsym(handle_.get(), function); }

void* SharedLibrary::required(const char* name) const {
    void* function = find(name);
    if (function == nullptr) {
        throw Error(ErrorKind::noOpenGl,
                    {"OpenGL cannot be used", "", name_ + " has no " + name, "update it, or use the backend cpu"});
    }
    return function;
}

} // namespace limner::gl
