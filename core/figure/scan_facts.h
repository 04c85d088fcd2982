#pragma once

#include "core/volume/histogram.h"
#include "core/volume/volume.h"

#include <optional>
#include <string>
#include <string_view>

namespace limner {

/// What a scan shows, as far as its header and its numbers tell.
enum class ScanKind {
    constant,   ///< one value
    slice,      ///< one voxel thick
    labels,     ///< integers that name regions
    ctHead,     ///< Hounsfield units (with or without an offset), a head
    ctBody,     ///< Hounsfield units, a trunk
    ctContrast, ///< Hounsfield units, a trunk with contrast medium in heart and vessels
    ctSlab,     ///< Hounsfield units, a few slices only: a section
    ctWindowed, ///< CT that was windowed to 8 bits: Hounsfield units are lost
    mrHead,     ///< MR of a head
    vessels,    ///< angiography: nearly empty, thin bright branches
    machined,   ///< a made part: flat faces along few directions
    specimen,   ///< anything else with a boundary: micro-CT, plants, embryos, float maps
};

/// Measured once per volume: the histogram, classes of values and the guess at what the scan is.
struct ScanFacts {
    Histogram histogram;
    /// Thresholds of least within-class variance (Otsu 1979): two classes, and three.
    double otsu = 0;
    double otsuLower = 0;
    double otsuUpper = 0;
    double matterShare = 0; ///< of voxels above `otsu`
    /// value = huSlope * HU + huIntercept, where the values are Hounsfield units.
    std::optional<double> huIntercept;
    ScanKind kind = ScanKind::specimen;
    std::string why; ///< the grounds of the guess, for people
};

/// Whether the numbers name regions: small whole numbers, most of them with six equal neighbours. A scan's noise leaves
/// few such voxels.
bool looksLabelled(const Volume& volume);

ScanFacts examineScan(const Volume& volume);

/// Resolves an anchored value of a preset. An anchor is one of
///   `hu:300`   Hounsfield units, where the scan has them (an offset of 1024 is seen through)
///   `p0.98`    value below which that share of all voxels lies
///   `m0.9`     the same among matter: voxels above `otsu`
///   `otsu`, `otsu:1`, `otsu:2`   the threshold of two classes; the lower and the upper one of three
///   `low`, `high`   ends of the value range
///   `A~B:0.3`  three tenths of the way from anchor A to anchor B
/// Several may be joined by `|`: the first that the scan has is taken. Nothing where none is there or the text is none.
std::optional<double> resolveAnchor(const ScanFacts& facts, std::string_view text);

} // namespace limner
