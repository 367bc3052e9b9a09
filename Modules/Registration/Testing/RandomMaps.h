#pragma once

#include "RegistrationStep.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace palpate::test
{
using Random = std::mt19937_64;

inline Vector3 RandomVector(Random& random, double deviation)
{
  std::normal_distribution<double> normal(0.0, deviation);
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// A shift and a turn of given sizes (mm, rad) in random directions, about the origin.
inline Eigen::Affine3d RandomMove(Random& random, double shift, double turn)
{
  const Vector3 axis = RandomVector(random, 1.0).normalized();
  const Vector3 way = RandomVector(random, 1.0).normalized();
  return Eigen::Translation3d(shift * way) * Eigen::Affine3d(Eigen::AngleAxisd(turn, axis));
}

/// Turn of a map (rad) and its shift at the origin (mm).
struct MapSize
{
  explicit MapSize(const Eigen::Affine3d& map)
      : Turn(Eigen::AngleAxisd(map.linear()).angle()), Shift(map.translation().norm())
  {
  }
  double Turn;
  double Shift;
};

/// Root mean squares of errors of many registrations, over those that they predicted.
class ErrorRatios
{
public:
  void Add(const Eigen::Affine3d& left, const PredictedPoseError& predicted)
  {
    const MapSize size(left);
    this->Turns += size.Turn * size.Turn;
    this->Shifts += size.Shift * size.Shift;
    this->PredictedTurns += predicted.Turn * predicted.Turn;
    this->PredictedShifts += predicted.Shift * predicted.Shift;
  }
  double Turn() const { return std::sqrt(this->Turns / this->PredictedTurns); }
  double Shift() const { return std::sqrt(this->Shifts / this->PredictedShifts); }

private:
  double Turns = 0.0;
  double Shifts = 0.0;
  double PredictedTurns = 0.0;
  double PredictedShifts = 0.0;
};
} // namespace palpate::test
