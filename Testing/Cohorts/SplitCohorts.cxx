#include "SplitCohorts.h"

#include "IcosahedronDirections.h"
#include "LinearModel.h"
#include "ModelFile.h"
#include "MultivariateTest.h"
#include "PermutationTest.h"
#include "ShapeModes.h"
#include "ShapeVector.h"

#include <Eigen/QR>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <variant>

namespace palpate::test
{
namespace
{
constexpr Eigen::Index Scores = 10;

LinearDesign DesignOf(const std::vector<std::string>& groups, const std::vector<double>& volumes)
{
  CovariateTable table(groups);
  table.Add("group", groups);
  std::vector<std::string> texts(volumes.size());
  std::transform(volumes.begin(), volumes.end(), texts.begin(),
                 [](double volume) { return std::to_string(volume); });
  table.Add("volume", texts);
  ModelFormula formula;
  LinearDesign design;
  const Status parsed = ModelFormula::Parse("~ group + volume", formula);
  const Status made = MakeLinearDesign(table, formula, {}, design);
  if (!parsed.IsOk() || !made.IsOk())
  {
    throw std::runtime_error(made.Message());
  }
  return design;
}
} // namespace

SplitCohorts::SplitCohorts(CohortGroup group, std::uint64_t seed)
    : Group(std::move(group)),
      Mean(FindNormalDisplacement(ShapeOf(this->Group, -1, 0.0), TestedFrequency)),
      Directions(IcosahedronDirections(TestedFrequency).Directions()),
      Coefficients(CoefficientsOf(this->Group)), Random(seed)
{
}

SurfaceBump SplitCohorts::BumpAt(const BumpPlace& place, double height) const
{
  return {std::get<RadialModel>(ShapeOf(this->Group, -1, 0.0)), place.Direction, height,
          BumpExtent};
}

Eigen::MatrixXd SplitCohorts::ReadCoefficients(const std::filesystem::path& folder) const
{
  Eigen::MatrixXd masks(this->Coefficients.rows(), this->Coefficients.cols());
  for (Eigen::Index row = 0; row < masks.rows(); ++row)
  {
    const std::string& name = this->Group.Rows[static_cast<std::size_t>(row)].Case;
    const OrganModel model = ReadModel(folder / (name + ".json")).Surface;
    masks.row(row) = VectorOf(WithDegree(model, DegreeOf(this->Group.Models[0])));
  }
  return masks;
}

BumpedCases SplitCohorts::WithBump(const SurfaceBump& bump, Eigen::MatrixXd flat,
                                   Eigen::MatrixXd masks) const
{
  BumpedCases bumped{bump, std::move(flat), std::move(masks), {}, {}};
  const Eigen::HouseholderQR<Eigen::MatrixXd> project(this->Mean.PerCoefficient);
  const Eigen::VectorXd shape = this->ShapeOfBump(bump);
  const Eigen::VectorXd added = project.solve(shape);
  bumped.Moved.resize(this->Coefficients.rows(), shape.size());
  for (Eigen::Index row = 0; row < bumped.Moved.rows(); ++row)
  {
    bumped.Moved.row(row) = shape + this->MovedBy(-this->ShiftOf(row, added), row);
  }
  bumped.MovedCoefficients = project.solve(bumped.Moved.transpose()).transpose();
  return bumped;
}

// Of the body's centre by these further coefficients, mm.
Vector3 SplitCohorts::ShiftOf(Eigen::Index row, const Eigen::VectorXd& added) const
{
  const auto centroid = [&](const Eigen::VectorXd& coefficients)
  {
    BodyMoments body;
    const RadialModel model(DegreeOf(this->Group.Models[0]),
                            std::vector<double>(coefficients.begin(), coefficients.end()),
                            Vector3::Zero());
    if (!MeasureBody(model, body).IsOk())
    {
      throw std::runtime_error("a body has no centre");
    }
    return body.CentroidWorld;
  };
  const Eigen::VectorXd coefficients = this->Coefficients.row(row);
  return centroid(coefficients + added) - centroid(coefficients);
}

// What moving the body does to its radii, along the mean's normal at the points; of first order.
Eigen::VectorXd SplitCohorts::MovedBy(const Vector3& shift, Eigen::Index row) const
{
  const auto& model = std::get<RadialModel>(this->Group.Models[static_cast<std::size_t>(row)]);
  Eigen::VectorXd moved(static_cast<Eigen::Index>(this->Directions.size()));
  for (std::size_t i = 0; i < this->Directions.size(); ++i)
  {
    const Vector3& direction = this->Directions[i];
    const Vector3 normal = model.Normal(direction);
    moved[static_cast<Eigen::Index>(i)] =
        shift.dot(normal) / direction.dot(normal) * direction.dot(this->Mean.Normals[i]);
  }
  return moved;
}

// A random order (Fisher and Yates), of which the first ones take part.
SplitCohorts::Draw SplitCohorts::NextDraw(const SplitSettings& settings)
{
  if (2 * static_cast<std::size_t>(settings.PerGroup) > this->Group.Rows.size())
  {
    throw std::runtime_error("too few cases for two groups");
  }
  std::vector<Eigen::Index> order(this->Group.Rows.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (std::size_t left = order.size(); left > 1; --left)
  {
    std::swap(order[left - 1], order[this->Random() % left]);
  }
  order.resize(2 * static_cast<std::size_t>(settings.PerGroup));
  std::vector<std::string> groups;
  std::vector<double> volumes;
  for (const Eigen::Index row : order)
  {
    groups.emplace_back(groups.size() % 2 == 0 ? "a" : "b");
    volumes.push_back(this->Group.Bodies[static_cast<std::size_t>(row)].Volume / 1000.0);
  }
  return {order, DesignOf(groups, volumes), this->Random()};
}

SplitCohorts::Data SplitCohorts::DataOf(const Draw& draw) const
{
  const auto count = static_cast<Eigen::Index>(draw.Rows.size());
  Eigen::MatrixXd drawn(count, this->Coefficients.cols());
  for (Eigen::Index i = 0; i < count; ++i)
  {
    drawn.row(i) = this->Coefficients.row(draw.Rows[static_cast<std::size_t>(i)]);
  }
  return {drawn, drawn * this->Mean.PerCoefficient.transpose()};
}

SplitResult SplitCohorts::Test(const SplitSettings& settings, const Draw& draw, const Data& data,
                               std::size_t point) const
{
  const DesignTerm& group = draw.Design.Terms[0];
  ShapeModes modes;
  MultivariateTest scores;
  PermutationTest points;
  PermutationSettings permutations;
  permutations.Count = settings.Permutations;
  permutations.Seed = draw.Seed;
  if (!FindShapeModes(data.Coefficients, modes).IsOk())
  {
    throw std::runtime_error("no modes");
  }
  const LinearDesign design =
      WithColumns(draw.Design, modes.Scores.leftCols(settings.Modes), ModeNames(settings.Modes));
  if (!TestTogether(draw.Design, group, modes.Scores.leftCols(Scores), scores).IsOk() ||
      !TestByPermutation(FindEffectSpace(design, group), data.Moved,
                         {this->Mean.Areas, this->Mean.Edges}, permutations, {}, points)
           .IsOk())
  {
    throw std::runtime_error("a test failed");
  }
  SplitResult result;
  result.Scores = scores.Pillai.P;
  result.Surface = points.WholeP;
  result.Maximum = points.FamilyP.minCoeff();
  result.Enhanced = points.EnhancedP.minCoeff();
  result.Point = points.P[static_cast<Eigen::Index>(point)];
  const Eigen::MatrixXd there = data.Moved.col(static_cast<Eigen::Index>(point));
  result.Estimate = FitLinearModel(design, there).Coefficients(group.First, 0);
  return result;
}

void SplitCohorts::TestWhereTold(const Draw& draw, const Data& data, const Eigen::VectorXd& shape,
                                 SplitResult& result) const
{
  const Eigen::MatrixXd known = data.Moved * shape;
  result.Told =
      TestTerm(draw.Design, draw.Design.Terms[0], FitLinearModel(draw.Design, known), known).P[0];
}

Eigen::VectorXd SplitCohorts::ShapeOfBump(const SurfaceBump& bump) const
{
  Eigen::VectorXd shape(static_cast<Eigen::Index>(this->Directions.size()));
  std::transform(this->Directions.begin(), this->Directions.end(), shape.begin(),
                 [&](const Vector3& direction) { return bump.AlongNormal(direction); });
  return shape;
}

std::size_t SplitCohorts::PointOf(const SurfaceBump& bump) const
{
  const auto nearest = std::max_element(this->Directions.begin(), this->Directions.end(),
                                        [&](const Vector3& a, const Vector3& b)
                                        { return a.dot(bump.Place()) < b.dot(bump.Place()); });
  return static_cast<std::size_t>(nearest - this->Directions.begin());
}

SplitResult SplitCohorts::Next(const SplitSettings& settings)
{
  const Draw draw = this->NextDraw(settings);
  return this->Test(settings, draw, this->DataOf(draw), this->Random() % this->Mean.Points.size());
}

BumpedResult SplitCohorts::Next(const SplitSettings& settings, const BumpedCases& bumped)
{
  const Draw draw = this->NextDraw(settings);
  const Eigen::VectorXd shape = this->ShapeOfBump(bumped.Bump);
  Data ideal = this->DataOf(draw);
  Data masks = ideal;
  for (std::size_t i = 0; i < draw.Rows.size(); i += 2)
  {
    const auto row = static_cast<Eigen::Index>(i);
    masks.Coefficients.row(row) = bumped.Flat.row(draw.Rows[i]);
    ideal.Coefficients.row(row + 1) += bumped.MovedCoefficients.row(draw.Rows[i + 1]);
    ideal.Moved.row(row + 1) += bumped.Moved.row(draw.Rows[i + 1]);
    masks.Coefficients.row(row + 1) = bumped.Coefficients.row(draw.Rows[i + 1]);
  }
  masks.Moved = masks.Coefficients * this->Mean.PerCoefficient.transpose();
  const std::size_t point = this->PointOf(bumped.Bump);
  BumpedResult result{this->Test(settings, draw, ideal, point),
                      this->Test(settings, draw, masks, point)};
  if (bumped.Bump.Height() > 0.0)
  {
    this->TestWhereTold(draw, ideal, shape, result.Ideal);
    this->TestWhereTold(draw, masks, shape, result.Masks);
  }
  return result;
}

Eigen::VectorXd SplitCohorts::Found(const BumpedCases& bumped) const
{
  return (bumped.Coefficients - bumped.Flat) *
         this->Mean.PerCoefficient.row(static_cast<Eigen::Index>(this->PointOf(bumped.Bump)))
             .transpose();
}

double SplitCohorts::True(const BumpedCases& bumped) const
{
  return bumped.Moved.col(static_cast<Eigen::Index>(this->PointOf(bumped.Bump))).mean();
}

double SplitCohorts::InModelsDegree(const BumpedCases& bumped) const
{
  return (bumped.MovedCoefficients *
          this->Mean.PerCoefficient.row(static_cast<Eigen::Index>(this->PointOf(bumped.Bump)))
              .transpose())
      .mean();
}
} // namespace palpate::test
