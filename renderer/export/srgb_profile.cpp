#include "renderer/export/srgb_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <vector>

namespace limner {

namespace {

std::vector<std::uint8_t> makeProfile() {
    std::vector<std::uint8_t> bytes;
    const cmsHPROFILE profile = cmsCreate_sRGBProfile();
    if (profile == nullptr) {
        return bytes;
    }
    cmsUInt32Number size = 0;
    if (cmsSaveProfileToMem(profile, nullptr, &size) != 0) {
        bytes.resize(size);
        if (cmsSaveProfileToMem(profile, bytes.data(), &size) == 0) {
            bytes.clear();
        }
    }
    cmsCloseProfile(profile);
    // The header's date (ICC.1, 7.2.1: six 16-bit words from byte 24) is the moment of the call; a fixed one keeps
    // pictures reproducible to the byte.
    constexpr std::uint8_t kDate[12] = {0x07, 0xE8, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0}; // 1 January 2024
    if (bytes.size() >= 128) {                                                     // the header's length
        std::copy(std::begin(kDate), std::end(kDate), bytes.begin() + 24);
    }
    return bytes;
}

} // namespace

std::span<const std::uint8_t> srgbProfile() {
    static const std::vector<std::uint8_t> bytes = makeProfile();
    return bytes;
}

} // namespace limner
