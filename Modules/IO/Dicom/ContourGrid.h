#pragma once

#include "DicomContours.h"
#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A grid for contours that come without their images. Its slices are the contours' planes; pixels
/// are square, 1 mm or, if the median distance of adjacent points is smaller, that distance (but
/// not below 0.2 mm), or larger if there would be more than `mostVoxels`. Throws InputError if the
/// contours are not in parallel planes, or their planes do not fit to evenly spaced slices.
PALPATEIO_EXPORT ImageGrid GridOfContours(const std::filesystem::path& file,
                                          const DicomContours& contours, double mostVoxels,
                                          std::vector<std::string>& notes);

/// A part of a grid, which may extend beyond its ends: that around the contours, with at least one
/// voxel without them on every side, and `slices` more at both ends. Voxels keep their positions.
/// Throws InputError if it has more
/// than 4,096 voxels along an axis.
PALPATEIO_EXPORT ImageGrid GridAroundContours(const std::filesystem::path& file,
                                              const DicomContours& contours, ImageGrid grid,
                                              int slices);

/// A point as a continuous voxel index of a grid.
PALPATEIO_EXPORT Vector3 IndexOf(const ImageGrid& grid, const Vector3& pointWorld);
} // namespace palpate
