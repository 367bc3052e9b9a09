#pragma once

#include "SurfacePull.h"

#include <variant>

namespace palpate
{
/// All but the largest part of a mask is removed.
struct IslandRemoval
{
};

/// Cavities that a mask encloses are filled.
struct CavityFilling
{
};

/// A mask's surface is smoothed by a Gaussian; its size stays.
struct SurfaceSmoothing
{
  static constexpr double LargestDeviation = 20.0; ///< mm
  double Deviation = 1.0;                          ///< mm
};

/// What lies beyond a plane, where its normal points to, is removed.
struct PlaneCut
{
  Vector3 PointWorld = Vector3::Zero(); ///< mm, patient LPS
  Vector3 Normal = Vector3::UnitZ();    ///< of any length
};

inline bool operator==(const IslandRemoval& /*a*/, const IslandRemoval& /*b*/)
{
  return true;
}
inline bool operator==(const CavityFilling& /*a*/, const CavityFilling& /*b*/)
{
  return true;
}
inline bool operator==(const SurfaceSmoothing& a, const SurfaceSmoothing& b)
{
  return a.Deviation == b.Deviation;
}
inline bool operator==(const PlaneCut& a, const PlaneCut& b)
{
  return a.PointWorld == b.PointWorld && a.Normal == b.Normal;
}

/// One correction of a mask; of a model, pulls only.
using CorrectionStep =
    std::variant<SurfacePull, IslandRemoval, CavityFilling, SurfaceSmoothing, PlaneCut>;
} // namespace palpate
