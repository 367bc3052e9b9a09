#include "ParameterCorrespondence.h"

#include "ShapeVector.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
constexpr int SearchDegree = 6;
constexpr std::ptrdiff_t ImprovedStarts = 4;
constexpr double NoDistance = 1e-9; // mm; below it there is only rounding

// Rotations that map a cube with axes along the frame's onto itself, without the identity.
std::vector<Matrix3> CubeTurns()
{
  std::vector<Matrix3> turns;
  std::array<int, 3> order{{0, 1, 2}};
  do
  {
    for (unsigned signs = 0; signs < 8; ++signs)
    {
      Matrix3 turn = Matrix3::Zero();
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        turn(order[axis], axis) = (signs >> axis & 1U) != 0U ? -1.0 : 1.0;
      }
      if (turn.determinant() > 0.0 && !turn.isIdentity())
      {
        turns.push_back(turn);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return turns;
}

bool IsRadial(const OrganModel& shape)
{
  return std::holds_alternative<RadialModel>(shape);
}

// 1 over each shape's distance from the geometric median (one shape per column).
Eigen::VectorXd MedianWeights(const Eigen::MatrixXd& shapes)
{
  constexpr int MostRounds = 100;
  constexpr double EnoughChange = 1e-6; // mm
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(shapes.cols());
  Eigen::VectorXd median = shapes.rowwise().mean();
  for (int round = 0; round < MostRounds; ++round)
  {
    const Eigen::VectorXd distances = (shapes.colwise() - median).colwise().norm();
    // A shape at the median itself would have all the weight.
    const double least = std::max(0.01 * distances.mean(), NoDistance);
    weights = distances.cwiseMax(least).cwiseInverse();
    const Eigen::VectorXd next = shapes * weights / weights.sum();
    const double change = (next - median).norm();
    median = next;
    if (change < EnoughChange)
    {
      break;
    }
  }
  return weights;
}

/// The closest orientations of a shape, its own and others, in low harmonics.
class OrientationSearch
{
public:
  OrientationSearch(const OrganModel& shape, const OrganModel& target)
      : Shape(shape), Target(target)
  {
  }

  void Run(const std::vector<Matrix3>& turns, ParameterCorrespondence& found)
  {
    this->TryParameters(turns);
    this->Report(false, found);
    if (!IsRadial(this->Shape))
    {
      this->TryBody();
      ParameterCorrespondence body;
      this->Report(true, body);
      if (body.TurnRatio() > found.TurnRatio())
      {
        body.Distance = found.Distance;
        found = body;
      }
    }
  }

private:
  void TryParameters(const std::vector<Matrix3>& turns)
  {
    std::vector<SphereRotation> starts{{}};
    for (const Matrix3& turn : turns)
    {
      starts.push_back({Matrix3::Identity(), turn});
    }
    starts.push_back(this->Target.StartFor(this->Shape, Matrix3::Identity()));
    std::vector<SuperposedShape> candidates;
    for (const SphereRotation& start : starts)
    {
      candidates.push_back(this->Target.At(this->Shape, start));
      this->Take(start.Parameters, candidates.back());
    }
    // The shape's own orientation is improved in any case.
    std::partial_sort(candidates.begin() + 1, candidates.begin() + 1 + ImprovedStarts,
                      candidates.end(),
                      [](const SuperposedShape& one, const SuperposedShape& other)
                      { return one.ShapeResidual < other.ShapeResidual; });
    candidates.resize(1 + ImprovedStarts);
    for (const SuperposedShape& candidate : candidates)
    {
      const SuperposedShape optimum = this->Target.FitParameters(this->Shape, candidate.Rotation);
      this->Take(optimum.Rotation.Parameters, optimum);
    }
  }
  void TryBody()
  {
    std::array<Matrix3, 4> turns{Matrix3::Identity()};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      turns[axis + 1] = Eigen::AngleAxisd(M_PI, Vector3::Unit(static_cast<Eigen::Index>(axis)))
                            .toRotationMatrix();
    }
    this->Own = this->Other = Infinite();
    for (const Matrix3& turn : turns)
    {
      const SphereRotation start = this->Target.StartFor(this->Shape, turn);
      this->Take(turn, this->Target.At(this->Shape, start));
      const SuperposedShape optimum = this->Target.Fit(this->Shape, start);
      this->Take(optimum.Rotation.Body, optimum);
    }
  }

  static SuperposedShape Infinite()
  {
    SuperposedShape none;
    none.ShapeResidual = std::numeric_limits<double>::infinity();
    return none;
  }
  void Take(const Matrix3& turn, const SuperposedShape& found)
  {
    SuperposedShape& best = AngleOf(turn) < SmallestOtherTurn ? this->Own : this->Other;
    best = found.ShapeResidual < best.ShapeResidual ? found : best;
  }
  void Report(bool turnsBody, ParameterCorrespondence& found) const
  {
    found.Turn = this->Other.Rotation;
    found.TurnsBody = turnsBody;
    found.OwnDistance = this->Own.ShapeResidual;
    found.TurnedDistance = this->Other.ShapeResidual;
  }

  const OrganModel& Shape;
  ShapeSuperposition Target;
  SuperposedShape Own = Infinite();
  SuperposedShape Other = Infinite();
};
} // namespace

double ParameterCorrespondence::TurnRatio() const
{
  const bool isNothing = this->OwnDistance <= NoDistance && this->TurnedDistance <= NoDistance;
  return isNothing ? 1.0 : this->OwnDistance / this->TurnedDistance;
}

bool ParameterCorrespondence::IsFlipped() const
{
  return this->TurnRatio() > FlippedRatio;
}

double ParameterCorrespondence::TurnAngle() const
{
  return AngleOf(this->TurnsBody ? this->Turn.Body : this->Turn.Parameters);
}

Status CompareParameters(const std::vector<OrganModel>& shapes, const KernelProgress& progress,
                         std::vector<ParameterCorrespondence>& cases)
{
  cases.clear();
  if (shapes.size() < 3)
  {
    return Status::Failure("correspondence needs at least three shapes");
  }
  const std::vector<Matrix3> turns = CubeTurns();
  Eigen::MatrixXd vectors(VectorOf(shapes.front()).size(),
                          static_cast<Eigen::Index>(shapes.size()));
  for (Eigen::Index i = 0; i < vectors.cols(); ++i)
  {
    vectors.col(i) = VectorOf(shapes[static_cast<std::size_t>(i)]);
  }
  const Eigen::VectorXd weights = MedianWeights(vectors);
  const Eigen::VectorXd sum = vectors * weights;
  const int degree = std::min(SearchDegree, DegreeOf(shapes.front()));
  for (Eigen::Index i = 0; i < vectors.cols(); ++i)
  {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(vectors.cols())))
    {
      return Status::Failure("cancelled");
    }
    const OrganModel& shape = shapes[static_cast<std::size_t>(i)];
    const Eigen::VectorXd others =
        (sum - weights[i] * vectors.col(i)) / (weights.sum() - weights[i]);
    const OrganModel low = WithDegree(shape, degree);
    ParameterCorrespondence one;
    one.Distance = RmsOverSphere(vectors.col(i) - others);
    OrientationSearch(low, WithDegree(ShapeFrom(others, shape), degree)).Run(turns, one);
    cases.push_back(one);
  }
  return Status::Success();
}

double UpperLogFence(std::vector<double> values)
{
  constexpr std::size_t LeastCount = 8;
  constexpr double FenceWidth = 1.5;
  if (values.size() < LeastCount)
  {
    return std::numeric_limits<double>::infinity();
  }
  for (double& value : values)
  {
    value = std::log(std::max(value, NoDistance));
  }
  std::sort(values.begin(), values.end());
  const auto quartile = [&](double share)
  {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(below);
    return (1.0 - part) * values[below] + part * values[std::min(below + 1, values.size() - 1)];
  };
  const double third = quartile(0.75);
  return std::exp(third + FenceWidth * (third - quartile(0.25)));
}
} // namespace palpate
