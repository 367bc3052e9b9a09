// Moments of samples, the Gram matrix computed from them, and residuals with their moments, against
// dense sums over the samples, for every instruction set.
#include "GramAssembly.h"
#include "MomentKernelChoice.h"
#include "ResidualMoments.h"
#include "SampleMoments.h"

#include "InstructionSets.h"
#include "RandomShapes.h"
#include "WorstCase.h"

#include <Eigen/Core>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace palpate::sample_moments_test
{
namespace
{
using test::NameOf;
using test::Random;
using test::RunnableInstructionSets;
using test::WorstCase;

// Directions everywhere, at and near both poles; uneven weights, some zero.
struct Case
{
  explicit Case(int degree, int count = 403) // not a multiple of the chunk size
      : Degree(degree)
  {
    Random random(static_cast<unsigned>(800 + degree));
    this->Directions = test::RandomDirections(random, count);
    for (const double z : {1.0, -1.0})
    {
      this->Directions.emplace_back(0.0, 0.0, z);
      for (const double off : {1e-4, 1e-8, 1e-15})
      {
        this->Directions.emplace_back(Vector3(off, -0.5 * off, z).normalized());
      }
    }
    this->Truth = test::RandomCoefficients(random, degree);
    const RadialModel model(degree, this->Truth, Vector3::Zero());
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Vector3& u : this->Directions)
    {
      this->Radii.push_back(model.Radius(u) + uniform(random));
      this->Weights.push_back(uniform(random) < 0.1 ? 0.0 : uniform(random));
      this->WeightSum += this->Weights.back();
    }
  }

  SampleView View(std::size_t first = 0,
                  std::size_t end = std::numeric_limits<std::size_t>::max()) const
  {
    end = std::min(end, this->Radii.size());
    return {this->Directions[first].data(), &this->Weights[first], &this->Radii[first],
            static_cast<long>(end - first)};
  }

  // Columns are samples.
  Eigen::MatrixXd Harmonics() const
  {
    const SphericalHarmonicBasis basis(this->Degree);
    Eigen::MatrixXd values(static_cast<Eigen::Index>(basis.Size()),
                           static_cast<Eigen::Index>(this->Radii.size()));
    for (std::size_t i = 0; i < this->Radii.size(); ++i)
    {
      basis.Evaluate(this->Directions[i], values.col(static_cast<Eigen::Index>(i)).data());
    }
    return values;
  }
  Eigen::Map<const Eigen::VectorXd> WeightVector() const
  {
    return {this->Weights.data(), static_cast<Eigen::Index>(this->Weights.size())};
  }
  Eigen::Map<const Eigen::VectorXd> RadiusVector() const
  {
    return {this->Radii.data(), static_cast<Eigen::Index>(this->Radii.size())};
  }

  int Degree;
  std::vector<Vector3> Directions;
  std::vector<double> Radii;
  std::vector<double> Weights;
  std::vector<double> Truth;
  double WeightSum = 0.0;
};

const moments::Kernel& Fastest()
{
  return moments::KernelFor(FastestInstructionSet());
}

Eigen::MatrixXd GramOf(const MomentTables& tables, const moments::Kernel& kernel,
                       const SampleMoments& moments)
{
  const int size = (tables.Degree() + 1) * (tables.Degree() + 1);
  PackedTriangle packed(size);
  GramAssembly(tables, kernel).Assemble(tables, moments.Weights(), 1.0, packed);
  Eigen::MatrixXd gram(size, size);
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      gram(i, j) = packed.At(i, j);
      gram(j, i) = gram(i, j);
    }
  }
  return gram;
}

// Absolute size of the terms of a sum with the harmonics.
double SizeOf(const Case& c)
{
  return c.WeightSum * (c.Degree + 1) * (c.Degree + 1) / (4.0 * M_PI);
}

TEST(SampleMoments, GramMatrixEqualsDenseProduct)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const moments::Kernel& kernel = moments::KernelFor(set);
    for (const int degree : {0, 1, 2, 3, 4, 5, 7, 8, 12, 13, 16, 24})
    {
      const Case c(degree);
      const auto tables = std::make_shared<const MomentTables>(degree, kernel.Lanes);
      SampleMoments moments(tables, kernel);
      moments.Add(c.View());
      const Eigen::MatrixXd harmonics = c.Harmonics();
      const Eigen::MatrixXd dense =
          harmonics * c.WeightVector().asDiagonal() * harmonics.transpose();
      // Some roundings of sums of (degree + 1)^2 / 4 pi times all weights; measured below 4
      // epsilon.
      EXPECT_LE((GramOf(*tables, kernel, moments) - dense).cwiseAbs().maxCoeff(),
                20 * std::numeric_limits<double>::epsilon() * SizeOf(c))
          << NameOf(set) << " degree " << degree;
      std::vector<double> right(static_cast<std::size_t>(dense.rows()));
      moments.RightSide(right.data());
      const Eigen::VectorXd denseRight =
          harmonics * c.WeightVector().cwiseProduct(c.RadiusVector());
      EXPECT_LE((Eigen::Map<Eigen::VectorXd>(right.data(), dense.rows()) - denseRight)
                    .cwiseAbs()
                    .maxCoeff(),
                20 * std::numeric_limits<double>::epsilon() * SizeOf(c) *
                    c.RadiusVector().cwiseAbs().maxCoeff())
          << NameOf(set) << " degree " << degree;
    }
  }
}

TEST(SampleMoments, AreAccurateAtDegree64)
{
  const Case c(64, 700);
  const moments::Kernel& kernel = moments::KernelFor(FastestInstructionSet());
  const auto tables = std::make_shared<const MomentTables>(64, kernel.Lanes);
  SampleMoments moments(tables, kernel);
  moments.Add(c.View());
  PackedTriangle gram(65 * 65);
  GramAssembly(*tables, kernel).Assemble(*tables, moments.Weights(), 1.0, gram);
  const Eigen::MatrixXd harmonics = c.Harmonics();
  WorstCase worst;
  for (int i = 0; i < 65 * 65; i += 13) // a sample of the nine million entries
  {
    for (int j = 0; j <= i; j += 7)
    {
      const double dense =
          harmonics.row(i).cwiseProduct(c.WeightVector().transpose()).dot(harmonics.row(j));
      worst.Add(gram.At(i, j) - dense);
    }
  }
  // The families are orthogonal for the weight of their first order; those of the three orders
  // after it lose a factor of 64 or so near the poles.
  EXPECT_LE(worst.Value(), 64 * 20 * std::numeric_limits<double>::epsilon() * SizeOf(c));
}

// The documented bound between any two orders of the samples or partitions.
double Bound(const Case& c)
{
  return (static_cast<double>(c.Radii.size()) / 32.0 + 12.0 * c.Degree + 40.0) *
         std::numeric_limits<double>::epsilon() * c.WeightSum;
}

double LargestDifference(const SampleMoments& a, const SampleMoments& b, int degree)
{
  WorstCase worst;
  for (int i = 0; i < 2 * moments::MomentCount(2 * degree); ++i)
  {
    worst.Add(a.Weights()[i] - b.Weights()[i]);
  }
  return worst.Value();
}

TEST(SampleMoments, SampleOrderMattersOnlyWithinBound)
{
  Random random(840);
  for (const int degree : {3, 12})
  {
    Case c(degree, 4000);
    const auto tables = std::make_shared<const MomentTables>(degree, Fastest().Lanes);
    SampleMoments moments(tables, Fastest());
    moments.Add(c.View());
    for (int trial = 0; trial < 5; ++trial)
    {
      std::vector<std::size_t> order(c.Radii.size());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), random);
      Case shuffled = c;
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        shuffled.Directions[i] = c.Directions[order[i]];
        shuffled.Weights[i] = c.Weights[order[i]];
        shuffled.Radii[i] = c.Radii[order[i]];
      }
      SampleMoments others(tables, Fastest());
      others.Add(shuffled.View());
      EXPECT_LE(LargestDifference(moments, others, degree), Bound(c));
    }
  }
}

TEST(SampleMoments, BoundDetectsMissingSample)
{
  constexpr int Degree = 12;
  Case c(Degree, 4000);
  const auto tables = std::make_shared<const MomentTables>(Degree, Fastest().Lanes);
  SampleMoments whole(tables, Fastest());
  whole.Add(c.View());
  c.Weights[17] += 1e-9 * c.WeightSum;
  SampleMoments changed(tables, Fastest());
  changed.Add(c.View());
  EXPECT_GT(LargestDifference(whole, changed, Degree), Bound(c));
}

TEST(SampleMoments, PropagateNan)
{
  Case c(3);
  c.Weights[5] = std::nan("");
  const auto tables = std::make_shared<const MomentTables>(3, Fastest().Lanes);
  SampleMoments moments(tables, Fastest());
  moments.Add(c.View());
  EXPECT_TRUE(std::isnan(moments.Weights()[0]));
}

TEST(ResidualMoments, MatchModelEvaluation)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const moments::Kernel& kernel = moments::KernelFor(set);
    for (const int degree : {0, 1, 3, 4, 12, 24})
    {
      const Case c(degree);
      const auto tables = std::make_shared<const MomentTables>(degree, kernel.Lanes);
      ResidualMoments residual(tables, kernel);
      const RadialModel model(degree, c.Truth, Vector3::Zero(),
                              RadialModel::Formulation::Recurrence);
      for (const std::size_t count :
           {std::size_t{1}, std::size_t{31}, std::size_t{32}, std::size_t{33}, c.Radii.size()})
      {
        std::vector<double> residuals(count + 1, -7.0);
        std::vector<double> sums(c.Truth.size());
        residual.Find(c.View(0, count), c.Truth.data(), residuals.data(), sums.data());
        Eigen::VectorXd weighted(static_cast<Eigen::Index>(c.Radii.size()));
        weighted.setZero();
        for (std::size_t i = 0; i < count; ++i)
        {
          const double exact = c.Radii[i] - model.Radius(c.Directions[i]);
          // Coefficients of unit size: some roundings of (degree + 1) of them.
          ASSERT_NEAR(residuals[i], exact, 1e-14 * (degree + 1) * (degree + 1)) << NameOf(set);
          weighted[static_cast<Eigen::Index>(i)] = c.Weights[i] * exact;
        }
        ASSERT_EQ(residuals[count], -7.0) << "written past the end";
        const Eigen::VectorXd dense = c.Harmonics() * weighted;
        ASSERT_LE(
            (Eigen::Map<Eigen::VectorXd>(sums.data(), dense.size()) - dense).cwiseAbs().maxCoeff(),
            1e-14 * SizeOf(c) * (degree + 1) * (degree + 1))
            << NameOf(set) << " degree " << degree;
      }
    }
  }
}

TEST(ResidualMoments, GiveRightHandSideForZeroModel)
{
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const moments::Kernel& kernel = moments::KernelFor(set);
    const Case c(12);
    const auto tables = std::make_shared<const MomentTables>(12, kernel.Lanes);
    std::vector<double> sums(169);
    std::vector<double> right(169);
    const std::vector<double> zeros(169);
    std::vector<double> residuals(c.Radii.size());
    ResidualMoments(tables, kernel).Find(c.View(), zeros.data(), residuals.data(), sums.data());
    EXPECT_EQ(residuals, c.Radii);
    SampleMoments moments(tables, kernel);
    moments.Add(c.View());
    moments.RightSide(right.data());
    for (std::size_t i = 0; i < 169; ++i)
    {
      // The order of products differs: rounding errors of sums of this size.
      EXPECT_NEAR(sums[i], right[i], 1e-14 * SizeOf(c) * 10.0) << NameOf(set);
    }
  }
}
} // namespace
} // namespace palpate::sample_moments_test
