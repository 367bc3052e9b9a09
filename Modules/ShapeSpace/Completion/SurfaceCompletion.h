#pragma once

#include "SurfacePosterior.h"
#include "SurfaceTouch.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// An organ of any shape from touches, a group's prior and perhaps another organ of the patient:
/// the most probable surface, and how sure it is. Each round takes the nearest place of the surface
/// for each touch (with a normal: also as inclined), and then is a closed form (SurfacePosterior):
/// distances along the normals, tangents that a touch's normal is perpendicular to, and distances
/// of the surface from the other organ. Millimetres, patient LPS. Not thread-safe.
class SurfaceCompletion
{
public:
  static constexpr int PlaceFrequency = 17; ///< 2,892 parameters among which the nearest is found
  /// A difference of normals counts as much as this distance, mm times 1 - cosine.
  static constexpr double NormalWeight = 16.0;
  /// What the modes and the parameters of a group leave out, mm: part of every standard deviation.
  static constexpr double LeftOut = 0.5;
  /// Neighbouring distances from the other organ go together more than their covariance says.
  static constexpr double WallFactor = 1.4;

  /// `clickWorld` (mm): near the organ's centroid.
  SurfaceCompletion(std::shared_ptr<const SurfacePrior> prior, const Vector3& clickWorld);
  /// With the other organ; no click is needed. Fails as SurfacePrior::Given.
  static Status WithKnown(std::shared_ptr<const SurfacePrior> prior, const LogSurface& known,
                          std::unique_ptr<SurfaceCompletion>& made);

  /// Completes the surface by all touches so far, none included, starting from that of the last
  /// call. Fails, and leaves everything as it was, for touches that CheckTouches refuses.
  Status Update(const std::vector<SurfaceTouch>& touches);

  SurfaceModel Model() const;
  /// RMS of the distances of the points from the surface (mm), and the most that touches of an
  /// organ like those of the prior leave.
  double Distance() const noexcept { return this->TouchDistance; }
  double LargestDistance() const noexcept;
  /// Fails if Distance is above LargestDistance.
  Status Judge() const;
  int Rounds() const noexcept { return this->RoundCount; } ///< of the last call

  /// Standard deviations (mm) along the normals at the parameters of an icosahedron.
  Eigen::VectorXd Deviations(int frequency) const;
  /// Where to touch next, as DeviationMap::NextTouches.
  std::vector<Vector3> NextTouches(int count) const;

  const std::shared_ptr<const SurfacePrior>& Prior() const noexcept { return this->Given; }
  const SurfacePosterior& Posterior() const noexcept { return this->Found; }
  /// The observations of the last round, their values and noise.
  const SurfaceRows& Rows() const noexcept { return this->Observed; }
  const Eigen::VectorXd& Values() const noexcept { return this->Measured; }
  const Eigen::MatrixXd& Noise() const noexcept { return this->Uncertainty; }

private:
  SurfaceCompletion(std::shared_ptr<const SurfacePrior> prior, SurfaceDistribution before);

  void Draw();
  Eigen::Index NearestTo(const SurfaceTouch& touch) const;
  void MatchTouches();
  void AddPoint(std::size_t touch, Eigen::Index& row);
  void AddTangents(std::size_t touch, Eigen::Index& row);
  void AddWalls(Eigen::Index& row);
  void AddStrokes(const std::vector<Eigen::Index>& rowOf);
  void Observe();
  void MeasureDistance();

  std::shared_ptr<const SurfacePrior> Given;
  SurfacePosterior Found;
  std::optional<LogSurfaceDistance> Wall;
  std::vector<SurfaceTouch> Touches;
  // The surface at the places, world:
  std::vector<Vector3> Parameters;
  std::vector<std::array<int, 3>> Triangles;
  Eigen::MatrixXd Harmonics;
  Eigen::MatrixXd WallHarmonics;
  Eigen::Matrix3Xd Points;
  Eigen::Matrix3Xd Normals;
  std::vector<Eigen::Index> PlaceOf; // of each touch
  SurfaceRows Observed;
  Eigen::VectorXd Measured;
  Eigen::MatrixXd Uncertainty;
  double TouchDistance = 0.0;
  int RoundCount = 0;
};
} // namespace palpate
