#include "LandmarkRegistration.h"

#include "SingularValues.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
using Points = std::vector<Vector3>;

constexpr double WidthInNoises = 3.0; // of the final weights
constexpr double UnknownNoise = 1.0;  // mm, of landmarks set by hand
constexpr double Narrowing = 1.4;     // of the weights' squared width, a round
constexpr double Degenerate = 1e-6;   // a spread over the largest one

// Weighted moments of pairs about their centroids.
struct PairMoments
{
  PairMoments(const Points& moving, const Points& fixed, const std::vector<double>& weights)
  {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < moving.size(); ++i)
    {
      this->From += weights[i] / sum * moving[i];
      this->To += weights[i] / sum * fixed[i];
    }
    for (std::size_t i = 0; i < moving.size(); ++i)
    {
      const Vector3 from = moving[i] - this->From;
      this->Cross += weights[i] / sum * (fixed[i] - this->To) * from.transpose();
      this->Spread += weights[i] / sum * from * from.transpose();
    }
  }

  Vector3 From = Vector3::Zero();
  Vector3 To = Vector3::Zero();
  Matrix3 Cross = Matrix3::Zero();  // fixed by moving
  Matrix3 Spread = Matrix3::Zero(); // of the moving ones
};

Eigen::Affine3d Fit(const Points& moving, const Points& fixed, const std::vector<double>& weights,
                    RegistrationKind kind)
{
  const PairMoments moments(moving, fixed, weights);
  Eigen::Affine3d map;
  if (kind == RegistrationKind::Affine)
  {
    map.linear() = moments.Cross * moments.Spread.inverse();
  }
  else
  {
    const SingularValues parts = SingularValuesOf(moments.Cross);
    const bool isReflected = (parts.Left * parts.Right.transpose()).determinant() < 0.0;
    const Vector3 signs(1.0, 1.0, isReflected ? -1.0 : 1.0);
    map.linear() = parts.Left * signs.asDiagonal() * parts.Right.transpose();
    if (kind == RegistrationKind::Similarity)
    {
      map.linear() *= parts.Values.dot(signs) / moments.Spread.trace();
    }
  }
  map.translation() = moments.To - map.linear() * moments.From;
  return map;
}

std::vector<double> DistancesOf(const Points& moving, const Points& fixed,
                                const Eigen::Affine3d& map)
{
  std::vector<double> distances(moving.size());
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    distances[i] = (map * moving[i] - fixed[i]).norm();
  }
  return distances;
}

Status Check(const Points& moving, const Points& fixed, RegistrationKind kind)
{
  const bool isAffine = kind == RegistrationKind::Affine;
  if (moving.size() != fixed.size())
  {
    return Status::Failure("has " + std::to_string(moving.size()) + " landmarks for " +
                           std::to_string(fixed.size()) + "; each needs its partner");
  }
  if (moving.size() < (isAffine ? 4U : 3U))
  {
    return Status::Failure("needs at least " + std::string(isAffine ? "four" : "three") +
                           " pairs of landmarks, has " + std::to_string(moving.size()));
  }
  const auto isFinite = [](const Vector3& point) { return point.allFinite(); };
  if (!std::all_of(moving.begin(), moving.end(), isFinite) ||
      !std::all_of(fixed.begin(), fixed.end(), isFinite))
  {
    return Status::Failure("has landmarks that are not finite");
  }
  const std::vector<double> even(moving.size(), 1.0);
  for (const Matrix3& spread :
       {PairMoments(moving, fixed, even).Spread, PairMoments(fixed, moving, even).Spread})
  {
    const Vector3 values = SingularValuesOf(spread).Values;
    if (values[isAffine ? 2 : 1] <= Degenerate * Degenerate * values[0])
    {
      return Status::Failure(isAffine ? "has all landmarks in a plane"
                                      : "has all landmarks on a line");
    }
  }
  return Status::Success();
}

// The final weights' width (mm), of distances of pairs.
double FinalWidth(double noise)
{
  return WidthInNoises * (noise > 0.0 ? noise : UnknownNoise);
}

void Finish(const Points& moving, const Points& fixed, RegistrationKind kind, double noise,
            LandmarkRegistration& made)
{
  made.Residuals = DistancesOf(moving, fixed, made.Map);
  const double sum = std::accumulate(made.Weights.begin(), made.Weights.end(), 0.0);
  double squares = 0.0;
  Vector3 pivot = Vector3::Zero();
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    squares += made.Weights[i] * made.Residuals[i] * made.Residuals[i];
    pivot += made.Weights[i] / sum * fixed[i];
  }
  made.Rms = std::sqrt(squares / sum);
  if (kind == RegistrationKind::Affine)
  {
    return;
  }
  double spread = 0.0;
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    spread += made.Weights[i] / sum * (fixed[i] - pivot).squaredNorm();
  }
  const double radius = std::sqrt(spread);
  const RegistrationStep step(kind, pivot, radius);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(step.Count(), step.Count());
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::VectorXd row = step.Derivatives(fixed[i], Vector3::Unit(axis));
      normal += made.Weights[i] * row * row.transpose();
    }
  }
  // What remains of 3 sum equations, of which the unknowns took their number.
  const double freedom = std::max(3.0 * sum - step.Count(), 1.0);
  made.Error =
      PredictedPoseError::Of(normal, radius, noise > 0.0 ? noise : std::sqrt(squares / freedom));
}
} // namespace

Status RegisterLandmarks(const std::vector<Vector3>& moving, const std::vector<Vector3>& fixed,
                         RegistrationKind kind, double noise, LandmarkRegistration& made)
{
  if (Status status = Check(moving, fixed, kind); !status.IsOk())
  {
    return status;
  }
  LandmarkRegistration found;
  found.Weights.assign(moving.size(), 1.0);
  found.Map = Fit(moving, fixed, found.Weights, kind);
  const double width = FinalWidth(noise);
  std::vector<double> distances = DistancesOf(moving, fixed, found.Map);
  const double largest = *std::max_element(distances.begin(), distances.end());
  // Weights (w / (d^2 + w))^2, w from where no pair is far off to the final square.
  for (double square = std::max(2.0 * largest * largest, width * width);;
       square = std::max(square / Narrowing, width * width))
  {
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      found.Weights[i] = std::pow(square / (distances[i] * distances[i] + square), 2);
    }
    found.Map = Fit(moving, fixed, found.Weights, kind);
    distances = DistancesOf(moving, fixed, found.Map);
    if (square <= width * width)
    {
      break;
    }
  }
  Finish(moving, fixed, kind, noise, found);
  made = std::move(found);
  return Status::Success();
}
} // namespace palpate
