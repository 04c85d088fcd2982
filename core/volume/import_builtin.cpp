#include "core/volume/import_parts.h"
#include "core/volume/phantom.h"

namespace limner::importing {

namespace {

constexpr std::string_view kPrefix = "builtin:";
constexpr int kHeadSize = 256; // about a millimetre, as a real head CT

} // namespace

bool isBuiltin(const std::filesystem::path& path) { return path.native().starts_with(kPrefix); }

StoredVolume readBuiltin(Context& context) {
    const std::string name = context.path.native().substr(kPrefix.size());
    if (name != "head") {
        context.refuse("there is no built-in volume of that name", "use builtin:head");
    }
    context.task.beginPhase("making the built-in head");
    const auto head = makeHeadPhantom(kHeadSize);
    const Grid& grid = head->grid();
    StoredVolume stored;
    stored.type = ScalarType::int16;
    stored.dims = grid.dims;
    stored.values = ByteBuffer(grid.voxelCount() * bytesPerScalar(stored.type));
    const std::size_t rowBytes = static_cast<std::size_t>(grid.dims.x) * bytesPerScalar(stored.type);
    std::byte* row = stored.values.data();
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y, row += rowBytes) {
            head->copyRow(y, z, row);
        }
    }
    stored.axesMm = grid.voxelToMmMatrix();
    stored.originMm = grid.originMm;
    stored.slope = head->contents().slope;
    stored.intercept = head->contents().intercept;
    stored.modality = Modality::ct;
    stored.modalityKnown = true;
    context.report.format = "built-in head";
    return stored;
}

} // namespace limner::importing
