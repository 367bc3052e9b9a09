#pragma once

namespace palpate
{
/// What to do with a file whose index axes are left-handed. Such a file is either mirrored by a
/// wrong header or rightly stored in that order (as FSL and dcm2niix do); only its user knows.
enum class LeftHandedAxes
{
  Refuse,
  Reverse ///< one index axis: voxels keep their places in the patient
};
} // namespace palpate
