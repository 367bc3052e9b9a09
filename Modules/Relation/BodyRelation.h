#pragma once

#include "KernelProgress.h"
#include "MeshGap.h"
#include "RelatedBody.h"
#include "Status.h"

#include <vector>

namespace palpate
{
struct RelationSettings
{
  /// mm: surfaces that are as near are in contact.
  double Contact = 1.0;
  /// mm, ascending: how much of a body lies within these distances of another one.
  std::vector<double> Margins{2.0, 5.0, 10.0};

  /// The largest of all, mm.
  double Reach() const noexcept;
};

/// How much of a body lies near another one: inside it, or as near to its surface.
struct NearShare
{
  double Millimeters = 0.0;
  double Area = 0.0;   ///< of its own surface (RelatedBody::Own), 0 to 1
  double Volume = 0.0; ///< 0 to 1, from the centres in RelatedBody::Inside
};

/// One of two related bodies.
struct RelatedSide
{
  double ContactArea = 0.0; ///< mm^2 of its own surface within the contact distance of the other's
  std::vector<NearShare> Near;
  /// Distances (mm) of the surface's points from the other body, negative inside it, 1e30 far
  /// beyond the reach; empty if all of it is.
  std::vector<double> Distances;
};

/// Where two bodies lie to each other.
struct BodyRelation
{
  enum class Kind
  {
    Apart,
    Overlapping, ///< their surfaces touch or cross, or their masks share voxels
    Inside,      ///< the first one lies in the other
    Around       ///< the first one surrounds the other
  };

  Kind Is = Kind::Apart;
  /// Between the surfaces, also of bodies in each other: the wall between them.
  MeshGap Wall;
  double SharedVolume = 0.0; ///< mm^3
  RelatedSide One;
  RelatedSide Other;
  Vector3 Offset = Vector3::Zero(); ///< mm, patient LPS: from the first centroid to the other's
  double AxesAngle = 0.0;           ///< degrees between the longest axes, 0 to 90

  /// Least distance (mm) between the bodies; 0 if one lies in the other.
  double Distance() const noexcept { return this->Is == Kind::Apart ? this->Wall.Distance : 0.0; }
};

/// Fails only if `progress` cancels. Exact to rounding for triangles; distances of single points
/// are from models themselves, areas linear within triangles.
Status RelateBodies(const RelatedBody& one, const RelatedBody& other,
                    const RelationSettings& settings, const KernelProgress& progress,
                    BodyRelation& relation);
} // namespace palpate
