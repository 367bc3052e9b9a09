#pragma once

#include "PalpateFitModule.h"
#include "Vector3.h"

#include <array>

namespace palpate
{
/// A side of the patient by its name in files and options: "left".
struct PatientSide
{
  const char* Name;
  Vector3 World; ///< unit vector, patient LPS
};

/// Left, right, posterior, anterior, superior, inferior.
PALPATEFIT_EXPORT const std::array<PatientSide, 6>& PatientSides();
} // namespace palpate
