#include "ShapeGroup.h"

#include "CoefficientDistribution.h"
#include "IcosahedronDirections.h"
#include "OrderedTasks.h"
#include "SphericalHarmonicBasis.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double OddLimit = 2.2; // times the median
constexpr int TemplateFrequency = 6;
constexpr double TemplateDegrees[OutlineTemplates::Widths] = {8.0, 14.0, 22.0, 35.0};
constexpr Eigen::Index Count = (RadialProbe::Degree + 1) * (RadialProbe::Degree + 1);
} // namespace

OutlineTemplates::OutlineTemplates()
{
  const IcosahedronDirections rays(TemplateFrequency);
  this->Directions = rays.Directions();
  const SphericalHarmonicBasis basis(RadialProbe::Degree);
  this->Columns.resize(Count, static_cast<Eigen::Index>(this->Directions.size()) * Widths);
  Eigen::VectorXd values(Count);
  Eigen::Index column = 0;
  for (const Vector3& direction : this->Directions)
  {
    basis.Evaluate(direction, values.data());
    for (const double degrees : TemplateDegrees)
    {
      const double width = degrees / DegreesPerRadian;
      Eigen::Index at = 0;
      for (int degree = 0; degree <= RadialProbe::Degree; ++degree)
      {
        const double factor = std::exp(-0.5 * degree * (degree + 1) * width * width);
        const Eigen::Index orders = 2 * degree + 1;
        this->Columns.col(column).segment(at, orders) = factor * values.segment(at, orders);
        at += orders;
      }
      ++column;
    }
  }
}

ShapeGroup::ShapeGroup(const Eigen::MatrixXd& cases, const OutlineTemplates& templates)
{
  CoefficientDistribution group(cases);
  this->Mean_ = std::move(group.Mean);
  this->Factorise(group.Covariance, templates);
}

ShapeGroup::ShapeGroup(Eigen::VectorXd mean, const Eigen::MatrixXd& covariance,
                       const OutlineTemplates& templates)
    : Mean_(std::move(mean))
{
  this->Factorise(covariance, templates);
}

void ShapeGroup::Factorise(const Eigen::MatrixXd& covariance, const OutlineTemplates& templates)
{
  this->Factor.compute(covariance);
  if (this->Factor.info() == Eigen::Success)
  {
    this->Lengths = this->Factor.matrixL().solve(templates.Columns).colwise().norm();
  }
}

double ShapeGroup::Band(const Eigen::VectorXd& difference, int from, int to) const
{
  const Eigen::Index first = from * from;
  const Eigen::Index count = (to + 1) * (to + 1) - first;
  const Eigen::MatrixXd rows = this->Factor.matrixL().toDenseMatrix().middleRows(first, count);
  const Eigen::VectorXd of = difference.segment(first, count);
  return std::sqrt(of.dot((rows * rows.transpose()).llt().solve(of)) / static_cast<double>(count));
}

MaskStatistics ShapeGroup::Judge(const RadialOutline& outline,
                                 const OutlineTemplates& templates) const
{
  const Eigen::VectorXd difference = outline.Coefficients - this->Mean_;
  const Eigen::VectorXd solved = this->Factor.solve(difference);
  const Eigen::VectorXd scores =
      (templates.Columns.transpose() * solved).cwiseQuotient(this->Lengths);
  Eigen::Index best = 0;
  const double largest = scores.cwiseAbs().maxCoeff(&best);
  const Vector3& direction =
      templates.Directions[static_cast<std::size_t>(best / OutlineTemplates::Widths)];
  Eigen::VectorXd values(Count);
  SphericalHarmonicBasis(RadialProbe::Degree).Evaluate(direction, values.data());
  const double radius = std::exp(values.dot(outline.Coefficients));
  MaskStatistics found{{"shape", largest, outline.CenterWorld + radius * direction, scores[best]}};
  found.push_back({"band_2", this->Band(difference, 2, 2), outline.CenterWorld, 0.0});
  found.push_back({"band_3_5", this->Band(difference, 3, 5), outline.CenterWorld, 0.0});
  found.push_back({"band_6_12", this->Band(difference, 6, 12), outline.CenterWorld, 0.0});
  return found;
}

Eigen::MatrixXd OutlineRows(const std::vector<RadialOutline>& outlines,
                            const std::vector<bool>& isTaken, std::size_t without)
{
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(outlines.size()), Count);
  Eigen::Index count = 0;
  for (std::size_t n = 0; n < outlines.size(); ++n)
  {
    if (isTaken[n] && n != without)
    {
      rows.row(count++) = outlines[n].Coefficients;
    }
  }
  rows.conservativeResize(count, Eigen::NoChange);
  return rows;
}

std::vector<bool> TrimGroup(const std::vector<RadialOutline>& outlines,
                            const OutlineTemplates& templates, std::size_t atATime,
                            std::vector<MaskStatistics>& leftOut)
{
  std::vector<bool> isKept(outlines.size(), true);
  while (true)
  {
    OrderedTasks<MaskStatistics> tasks(outlines.size(), atATime,
                                       [&](std::size_t n)
                                       {
                                         const ShapeGroup others(OutlineRows(outlines, isKept, n),
                                                                 templates);
                                         return others.Judge(outlines[n], templates);
                                       });
    leftOut.clear();
    std::vector<double> largest;
    for (std::size_t n = 0; n < outlines.size(); ++n)
    {
      leftOut.push_back(tasks.Next());
      if (isKept[n])
      {
        largest.push_back(leftOut.back().front().Value);
      }
    }
    const auto middle = largest.begin() + static_cast<std::ptrdiff_t>(largest.size() / 2);
    std::nth_element(largest.begin(), middle, largest.end());
    const double limit = OddLimit * *middle;
    bool isDone = true;
    for (std::size_t n = 0; n < outlines.size(); ++n)
    {
      if (isKept[n] && leftOut[n].front().Value > limit)
      {
        isKept[n] = false;
        isDone = false;
      }
    }
    if (isDone)
    {
      return isKept;
    }
  }
}
} // namespace palpate
