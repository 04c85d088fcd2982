#include "widgets/artwork_tool.h"

#include "widgets/artwork_brush_tools.h"
#include "widgets/artwork_ellipse_tool.h"
#include "widgets/artwork_mark_tools.h"
#include "widgets/artwork_picker_tool.h"

#include <QLineF>

#include <utility>

namespace limner {

double ArtworkTool::away(glm::dvec2 place, const ToolPointer& pointer) const {
    return QLineF(toWidget(place), pointer.position).length();
}

void ArtworkTool::during(ExtractionDraft changed, const QString& label, bool ongoing) {
    host_.ask({std::move(changed), label, key_.during(name_), ongoing});
}

void ArtworkTool::again(const char* name, ExtractionDraft changed, const QString& label) {
    host_.ask({std::move(changed), label, key_.again(name_ = name), false});
}

void ArtworkTool::once(ExtractionDraft changed, const QString& label) {
    host_.ask({std::move(changed), label, {}, false});
}

std::unique_ptr<ArtworkTool> makeArtworkTool(ToolKind kind, ToolHost& host) {
    switch (kind) {
    case ToolKind::circle: return std::make_unique<EllipseTool>(host, true);
    case ToolKind::ellipse: return std::make_unique<EllipseTool>(host, false);
    case ToolKind::region: return std::make_unique<OutlineTool>(host);
    case ToolKind::brush: return std::make_unique<BrushTool>(host, BrushTool::On::region);
    case ToolKind::normal: return std::make_unique<NormalTool>(host);
    case ToolKind::crease: return std::make_unique<CreaseTool>(host);
    case ToolKind::open: return std::make_unique<OpenOutlineTool>(host);
    case ToolKind::ignore: return std::make_unique<BrushTool>(host, BrushTool::On::ignored);
    case ToolKind::picker: return std::make_unique<PickerTool>(host);
    }
    return nullptr;
}

} // namespace limner
