#pragma once

#include "IndexToWorld.h"
#include "VoxelMask.h"

#include <array>

namespace palpate
{
/// The same mask in a box from and to these image indices (inclusive); what lies outside is lost.
VoxelMask InBox(const VoxelMask& mask, const std::array<int, 3>& first,
                const std::array<int, 3>& last);

/// Whether a voxel of the image is in a mask; outside of its box none is.
bool HasVoxel(const VoxelMask& mask, const std::array<int, 3>& index) noexcept;

/// Plain edits of a mask whose box has a rim of voxels outside; the box stays. Lengths mm, patient
/// LPS.

/// Removes all but the largest part of voxels that share faces. Returns how many voxels went.
long long RemoveIslands(VoxelMask& mask);

/// Smooths the mask's surface: its signed distance is blurred by a Gaussian of this standard
/// deviation and cut at the level that keeps the number of voxels, up to equal values. Details
/// smaller than the deviation vanish, size stays. Allocates 16 bytes a voxel of the box, which
/// should have a rim of two deviations.
void SmoothMask(double deviation, VoxelMask& mask);

/// Removes the voxels whose centres lie beyond a plane, on the side to which `normal` points.
void CutMask(const Vector3& pointWorld, const Vector3& normal, const IndexToWorld& toWorld,
             VoxelMask& mask);
} // namespace palpate
