#pragma once

namespace palpate
{
/// What to do with a file whose index axes are left-handed, as FSL and dcm2niix write them and half
/// of all axis orders are.
enum class LeftHandedAxes
{
  Refuse, ///< where every left-handed file is known to have a wrong header
  Reverse ///< one index axis: voxels keep the places in the patient that the header gives them
};
} // namespace palpate
