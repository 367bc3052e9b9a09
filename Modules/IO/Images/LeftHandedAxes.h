#pragma once

namespace palpate
{
/// Handling of a file with left-handed index axes, as FSL and dcm2niix write them; half of all axis
/// orders are left-handed.
enum class LeftHandedAxes
{
  Refuse, ///< if every left-handed file is known to have a wrong header
  Reverse ///< reverses one index axis: voxels keep their positions in the patient
};
} // namespace palpate
