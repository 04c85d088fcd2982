#include "core/volume/import_parts.h"
namespace limner::importing {
StoredVolume readLegacyVtk(Context& context) { context.refuse("Limner does not read this format yet"); }
StoredVolume readVti(Context& context) { context.refuse("Limner does not read this format yet"); }
StoredVolume readPictures(Context& context) { context.refuse("Limner does not read this format yet"); }
StoredVolume readInvesalius(Context& context) { context.refuse("Limner does not read this format yet"); }
StoredVolume readRaw(Context& context) { context.refuse("Limner does not read this format yet"); }
StoredVolume readDicom(Context& context) { context.refuse("Limner does not read this format yet"); }
bool isPictureFolder(const std::filesystem::path&) { return false; }
} // namespace limner::importing
