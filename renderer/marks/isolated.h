#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace limner {

/// `tbb::parallel_for` for what is made once, on the first call: while it waits, the thread that makes it must not take
/// up a task that asks for the same thing.
template <typename Index, typename Body>
void isolatedFor(Index first, Index end, const Body& body) {
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(first, end, body); });
}

} // namespace limner
