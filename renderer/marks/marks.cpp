#include "renderer/marks/marks.h"

namespace limner {

bool Marks::empty() const { return dotCount() == 0 && strokeCount() == 0; }

std::size_t Marks::dotCount() const {
    std::size_t count = 0;
    for (const MarkGroup& group : groups)
        count += group.dots.size();
    return count;
}

std::size_t Marks::strokeCount() const {
    std::size_t count = 0;
    for (const MarkGroup& group : groups)
        count += group.strokes.size();
    return count;
}

} // namespace limner
