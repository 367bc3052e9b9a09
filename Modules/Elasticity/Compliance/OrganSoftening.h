#pragma once

#include "ComplianceMaps.h"

namespace palpate
{
/// From a model and its tissue to what is kept of an elastic organ.
struct OrganSoftening
{
  /// Raise it with every change of the numerics that changes results: what was kept by an earlier
  /// version (SofteningCache) is not used then.
  static constexpr int Version = 2;
  /// Elements carry harmonics up to this degree times their number across: of shorter ones, less
  /// than two elements long, the organ would be too stiff by tens of percent.
  static constexpr int MostDegreePerElement = 2;

  /// Radius (mm) below which a hollow needs DegreeInHollows: a ball that touches both sides of one
  /// of 2 mm and 90 degrees has an error of 14 % RMS with degree 12, 10 % with 16, 8 % with 20.
  static constexpr double SharpHollow = 3.0;
  static constexpr int UsualDegree = 12;
  static constexpr int DegreeInHollows = 20;

  int ElementsAcross = 16; ///< of a quarter of a great circle; see StarMesh
  int Degree = 0;          ///< of the reduced compliance; 0: the surface decides
  ComplianceMaps::Settings Maps;

  /// The degree that Make takes for this surface, at most what the elements carry.
  int DegreeFor(const RadialModel& model) const;
  /// Radius of the sharpest hollow of a surface, mm; infinite if there is none.
  static double SharpestHollow(const RadialModel& model);

  /// What was built.
  struct Account
  {
    double ElementEdge = 0.0; ///< mm, at the surface
    std::size_t Unknowns = 0;
  };

  /// Fails with the reasons of its parts (see StarMesh, AssembleStiffness, ReducedCompliance and
  /// ComplianceMaps), for an organ that nothing holds, and for maps that their Check would refuse.
  /// Takes seconds and, with 16 elements across, 0.7 GB.
  Status Make(const RadialModel& model, const ElasticSolid& solid, const KernelProgress& progress,
              ComplianceMaps& maps, Account& account) const;
};
} // namespace palpate
