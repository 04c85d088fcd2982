#pragma once

class QMimeData;
class QString;

namespace limner {

/// How a style travels by drag and drop: its key (widgets/style_source.h).
inline constexpr const char* kStyleMime = "application/x-limner-style";

} // namespace limner
