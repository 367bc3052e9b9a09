#pragma once

namespace palpate
{
/// Handling of a file whose index axes are not perpendicular, beyond what rounding of its header
/// explains (see CheckGrid): a tilted gantry, or an affine registration.
enum class ShearedAxes
{
  Refuse,  ///< its voxels are no boxes, which everything else assumes
  Resample ///< onto perpendicular axes: labels by the nearest voxel, images linearly
};
} // namespace palpate
