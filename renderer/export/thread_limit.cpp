#include "renderer/export/thread_limit.h"

#include <OpenImageIO/imageio.h>

#include <tbb/global_control.h>

#include <cassert>

namespace limner {

struct ThreadLimit::Control {
    explicit Control(int threads)
        : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
    tbb::global_control limit;
    int before = 0; ///< of OpenImageIO, which packs strips in threads of its own
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {
    assert(threads > 0);
    OIIO::getattribute("threads", control_->before);
    OIIO::attribute("threads", threads);
}

ThreadLimit::~ThreadLimit() { OIIO::attribute("threads", control_->before); }

} // namespace limner
