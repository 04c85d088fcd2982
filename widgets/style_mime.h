#pragma once

class QMimeData;
class QString;

namespace limner {

/// How a bundled style travels by drag and drop: its id.
inline constexpr const char* kStyleMime = "application/x-limner-style";

} // namespace limner
