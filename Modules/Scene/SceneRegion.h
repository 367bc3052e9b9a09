#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneSettings.h"
#include "Segmentation.h"
#include "Volume.h"

namespace palpate
{
/// An image of a structure's limited iso-value (see SceneStructure::IsLimited) on the grid of
/// `volume`: at least 0 where a voxel belongs to it. Between two values it is the distance in
/// values from the nearer one, so that interpolation between voxels meets both exactly; beyond the
/// border of the label, half-way between voxels, it changes its sign. Voxels whose values pass from
/// below the range to above it within one voxel are not in it, so no shell of partial volumes
/// appears around what is brighter.
///
/// `mask` is the segmentation of WithinFile, matched with the volume in mm; null without one.
/// Throws InputError, naming the file, for a missing label, and if no voxel or every voxel belongs
/// to the region; and Cancelled.
PALPATESCENE_EXPORT Volume MakeRegion(const SceneStructure& structure, const Volume& volume,
                                      const Segmentation* mask, const ProgressFunction& progress);

/// A label map of such an image: 1 in the region.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> LabelsOfRegion(vtkImageData* region);
} // namespace palpate
