#pragma once

#include "CenteredSurface.h"
#include "IndexedMesh.h"
#include "NearestOnMesh.h"
#include "OrganModel.h"

#include <vector>

namespace palpate
{
/// A model's surface drawn at points of itself, and exact distances from it. The nearest triangle
/// of the drawing finds where on the surface the closest point is, and Newton's method finds it
/// there: exact to rounding, except for points that are about equally far from two parts of the
/// surface. Immutable; queries are thread-safe.
class ModelFoot
{
public:
  explicit ModelFoot(const OrganModel& model);

  /// Points of the surface (mm, patient LPS), outward orientation; 32,000 triangles or more, after
  /// the model's degree.
  const IndexedMesh& Mesh() const noexcept { return this->Drawing; }
  /// The directions of the parameter sphere of which PointAt makes its points.
  const std::vector<Vector3>& MeshParameters() const noexcept { return this->Parameters; }
  /// The surface's point (mm) in a direction, of any length but 0, of the parameter sphere.
  Vector3 PointAt(const Vector3& direction) const noexcept;
  /// The same points, with a quarter of the triangles: for extrapolation. Allocates.
  IndexedMesh CoarseMesh() const;
  double Volume() const noexcept { return this->EnclosedVolume; } ///< mm^3, positive
  double Area() const noexcept { return this->SurfaceArea; }      ///< mm^2

  /// The parameter, a unit vector, of a point of the drawing; interpolated in its triangle.
  Vector3 ParameterAt(const NearestOnMesh::Result& near) const noexcept;
  /// Distance (mm) of a point from the surface, negative inside; `near` is the drawing's point
  /// nearest to it.
  double SignedDistance(const Vector3& query, const NearestOnMesh::Result& near) const noexcept;
  /// The parameter of the surface's point nearest to `query`, found as SignedDistance does.
  Vector3 FootOf(const Vector3& query, const NearestOnMesh::Result& near) const noexcept;

private:
  // Where Newton's method ends; `from` is relative to the surface's centre.
  struct Foot
  {
    Vector3 Parameter;
    CenteredSurface::SecondOrderSample Sample;
  };
  Foot FindFoot(const Vector3& from, const NearestOnMesh::Result& near) const noexcept;

  int Frequency; // of the icosahedron; even
  CenteredSurface Shape;
  std::vector<Vector3> Parameters; // of the drawing's points
  IndexedMesh Drawing;
  double Outward; // -1 if the surface is parametrised inside out
  double EnclosedVolume;
  double SurfaceArea;
};
} // namespace palpate
