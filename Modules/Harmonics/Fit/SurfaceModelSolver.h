#pragma once

#include "GramAssembly.h"
#include "MomentTables.h"
#include "PackedTriangle.h"
#include "ResidualMoments.h"
#include "SampleMoments.h"
#include "SurfaceModel.h"
#include "SurfaceSamples.h"

#include <array>
#include <memory>
#include <vector>

namespace palpate
{
/// Least squares for the three coordinates of a SurfaceModel, by normal equations
/// whose matrices are assembled from moments of the samples (SampleMoments, GramAssembly). A ridge
/// of strength times (l (l+1) / (L (L+1)))^2 / 4 pi per squared coefficient keeps the surface
/// smooth where no parameter lies.
///
/// An object keeps tables and memory for its degree L. Samples must stay alive and unchanged in
/// number between the calls.
class SurfaceModelSolver
{
public:
  SurfaceModelSolver(int degree, double strength);

  /// Minimises sum_i w_i |X(u_i) - p_i|^2. Returns false if the parameters do not determine the
  /// surface.
  bool FitPoints(const SurfaceSamples& samples);

  /// Prepares FitNormals for samples that differ from those of the last FitPoints in their points
  /// only. `tangentWeights` has one number t_i per sample; below about 0.01 the iterations converge
  /// slowly.
  void SetTangentWeights(const SurfaceSamples& samples, std::vector<double> tangentWeights);
  /// Minimises sum_i w_i ((n_i . r_i)^2 + t_i |r_i's tangential part|^2) for r_i = X(u_i) - p_i,
  /// starting at the last solution: points may slide along the surface at the price t_i. Conjugate
  /// gradients, preconditioned by the factor of FitPoints; `iterations` of them.
  void FitNormals(const SurfaceSamples& samples, int iterations);

  SurfaceModel Surface() const;

private:
  using Coordinates = std::array<CacheLineVector<double>, 3>;

  SampleView View(const SurfaceSamples& samples, const std::vector<double>& weights) const noexcept;
  Coordinates MakeCoordinates() const;
  void CopyCoordinate(const SurfaceSamples& samples, int axis);
  void NormalResiduals(const SurfaceSamples& samples, Coordinates& gradient);
  void AddRidge(PackedTriangle& matrix) const noexcept;
  void MultiplyNormal(const Coordinates& x, Coordinates& y) noexcept;
  double RidgeOf(int degree) const noexcept;

  int MaximumDegree;
  double Strength;
  std::shared_ptr<const MomentTables> Tables;
  SampleMoments Moments;
  ResidualMoments Residual;
  GramAssembly Assembly;
  PackedTriangle Factor;                   // of sum w Y Y^T and the ridge
  std::vector<PackedTriangle> Normal;      // xx, yx, yy, zx, zy, zz
  Vector3 Origin = Vector3::Zero();        // mm, subtracted from the points
  std::vector<double> TangentWeights;      // of the samples
  Coordinates Solution;                    // mm, around the origin
  std::vector<double> Values;              // one coordinate of all samples
  std::vector<double> Scaled;              // weights of one matrix
  std::array<std::vector<double>, 3> Left; // residuals
  CacheLineVector<double> Lower;
  CacheLineVector<double> Upper;
};
} // namespace palpate
