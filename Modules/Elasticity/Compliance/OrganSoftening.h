#pragma once

#include "ComplianceMaps.h"

namespace palpate
{
/// From a model and its tissue to what is kept of an elastic organ.
struct OrganSoftening
{
  /// Raise it with every change of the numerics that changes results: what was kept by an earlier
  /// version (SofteningCache) is not used then.
  static constexpr int Version = 1;
  /// Elements carry harmonics up to this degree times their number across: of shorter ones, less
  /// than two elements long, the organ would be too stiff by tens of percent.
  static constexpr int MostDegreePerElement = 2;

  int ElementsAcross = 16; ///< of a quarter of a great circle; see StarMesh
  int Degree = 12;         ///< of the reduced compliance, lowered to what the elements carry
  ComplianceMaps::Settings Maps;

  /// What was built.
  struct Account
  {
    double ElementEdge = 0.0; ///< mm, at the surface
    std::size_t Unknowns = 0;
  };

  /// Fails with the reasons of its parts (see StarMesh, AssembleStiffness, ReducedCompliance and
  /// ComplianceMaps), for an organ that nothing holds, and for maps that their Check would refuse.
  /// Takes seconds and, with 16 elements across, 0.7 GB.
  Status Make(const SphericalHarmonicModel& model, const ElasticSolid& solid,
              const KernelProgress& progress, ComplianceMaps& maps, Account& account) const;
};
} // namespace palpate
