#include "ShapeAsymmetry.h"

#include "ProcrustesAlignment.h"
#include "ShapeMirror.h"
#include "ShapeVector.h"

#include <cmath>
#include <string>

namespace palpate
{
namespace
{
Eigen::MatrixXd CoefficientRows(const std::vector<OrganModel>& shapes)
{
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(shapes.size()), VectorOf(shapes.front()).size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    rows.row(static_cast<Eigen::Index>(i)) = VectorOf(shapes[i]);
  }
  return rows;
}

// Coordinates that mirroring keeps.
Eigen::Index SymmetricCount(const OrganModel& like)
{
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(VectorOf(like).size());
  return (VectorOf(MirrorShape(ShapeFrom(ones, like))).array() > 0.0).count();
}
} // namespace

OrganModel MirroredTowards(const OrganModel& shape, const OrganModel& target)
{
  const OrganModel mirrored = MirrorShape(shape);
  if (std::holds_alternative<RadialModel>(shape))
  {
    return mirrored;
  }
  const ShapeSuperposition superposition(target);
  const SphereRotation start = superposition.StartFor(mirrored, Matrix3::Identity());
  return TurnShape(mirrored, superposition.FitParameters(mirrored, start).Rotation);
}

Status MakeMirroredSides(const std::vector<OrganModel>& shapes, bool turnsToMean,
                         const KernelProgress& progress, ShapeSides& sides)
{
  std::vector<OrganModel> all = shapes;
  for (const OrganModel& shape : shapes)
  {
    all.push_back(MirroredTowards(shape, shape));
  }
  if (turnsToMean)
  {
    ProcrustesResult result;
    if (Status status = AlignByProcrustes(all, nullptr, {}, result, progress); !status.IsOk())
    {
      return status;
    }
    all = std::move(result.Aligned);
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(shapes.size());
  sides = {{all.begin(), middle}, {middle, all.end()}};
  return Status::Success();
}

Status FindShapeAsymmetry(const ShapeSides& sides, bool arePairs, int frequency,
                          const PermutationSettings& flips, const KernelProgress& progress,
                          ShapeAsymmetry& asymmetry)
{
  if (sides.Left.size() < ShapeAsymmetry::FewestIndividuals)
  {
    return Status::Failure("asymmetry needs at least 3 individuals, but there are " +
                           std::to_string(sides.Left.size()));
  }
  const Eigen::MatrixXd left = CoefficientRows(sides.Left);
  const Eigen::MatrixXd right = CoefficientRows(sides.Right);
  const Eigen::Index symmetric = arePairs ? left.cols() : SymmetricCount(sides.Left.front());
  ShapeAsymmetry made;
  made.Anova =
      FindSideAnova(left, right, symmetric, arePairs ? left.cols() : left.cols() - symmetric);
  const Eigen::VectorXd mean = 0.5 * (left + right).colwise().mean().transpose();
  made.Surface = FindNormalDisplacement(ShapeFrom(mean, sides.Left.front()), frequency);
  const Eigen::MatrixXd differences = (left - right) * made.Surface.PerCoefficient.transpose();
  for (Eigen::Index i = 0; i < differences.rows(); ++i)
  {
    made.Individuals.push_back(RmsOverPoints(made.Surface, differences.row(i).transpose()));
  }
  const Status status = TestSides(differences, made.Surface.Areas, flips, progress, made.Points);
  if (status.IsOk())
  {
    asymmetry = std::move(made);
  }
  return status;
}

double RmsOverPoints(const NormalDisplacement& surface, const Eigen::VectorXd& displacements)
{
  const Eigen::Map<const Eigen::ArrayXd> areas(surface.Areas.data(),
                                               static_cast<Eigen::Index>(surface.Areas.size()));
  return std::sqrt((areas * displacements.array().square()).sum() / areas.sum());
}
} // namespace palpate
