#pragma once

#include "BumpedFit.h"
#include "CohortGroup.h"
#include "LinearDesign.h"
#include "NormalDisplacement.h"

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace palpate::test
{
/// p-values of a simulated study, one of each kind of test.
struct SplitResult
{
  double Scores = 1.0;   ///< Pillai, parametric
  double Surface = 1.0;  ///< of the whole surface, by permutation
  double Maximum = 1.0;  ///< least p of all points, corrected by the largest statistic
  double Enhanced = 1.0; ///< the same by cluster enhancement
  double Told = 1.0;  ///< parametric t of the mean displacement, weighted by the bump's true shape
  double Point = 1.0; ///< by permutation, of one point: uniform under the null hypothesis
  double Estimate = 0.0; ///< of the effect at that point, mm
};

/// One study with an effect, on two kinds of data.
struct BumpedResult
{
  SplitResult Ideal; ///< the bump added to the models: no mask, no fit, no correspondence error
  SplitResult Masks; ///< models fitted to masks with and without the bump
};

/// A bump, the models of all cases' masks without and with it, and what it does to their bodies,
/// without masks and fits: a row per case of the group. Centres are superimposed, so a bump moves
/// the rest of its body the other way, the more the smaller it is.
struct BumpedCases
{
  SurfaceBump Bump;
  Eigen::MatrixXd Flat;              ///< coefficients of the models of masks on the same slices
  Eigen::MatrixXd Coefficients;      ///< of the masks' models with the bump
  Eigen::MatrixXd Moved;             ///< along the mean's normal at the points, mm
  Eigen::MatrixXd MovedCoefficients; ///< the closest ones to it
};

struct SplitSettings
{
  int PerGroup = 30;
  int Permutations = 499;
  /// The first modes of the drawn cases together, whose scores are further covariates of the tests
  /// at points: what differs along them is not looked for.
  Eigen::Index Modes = 0;
};

/// Studies of two groups of real shapes, drawn at random, so that the null hypothesis is true by
/// construction whatever the shapes' distribution; the volume is a covariate. With a bump in one
/// group the alternative is true.
class SplitCohorts
{
public:
  SplitCohorts(CohortGroup group, std::uint64_t seed);

  /// `flat` and `masks` are the coefficients of all cases' models without and with the bump.
  BumpedCases WithBump(const SurfaceBump& bump, Eigen::MatrixXd flat, Eigen::MatrixXd masks) const;
  /// The coefficients of `folder`/CASE.json of every case. Throws InputError.
  Eigen::MatrixXd ReadCoefficients(const std::filesystem::path& folder) const;
  SurfaceBump BumpAt(const BumpPlace& place, double height) const;

  SplitResult Next(const SplitSettings& settings);
  BumpedResult Next(const SplitSettings& settings, const BumpedCases& bumped);

  /// Displacements (mm) at the bump's place of all masks' models: what the fits find of it.
  Eigen::VectorXd Found(const BumpedCases& bumped) const;
  /// The mean displacement at the bump's place, mm: of the bodies, and of the best models of the
  /// cohort's degree.
  double True(const BumpedCases& bumped) const;
  double InModelsDegree(const BumpedCases& bumped) const;

private:
  /// Who takes part, and in which group.
  struct Draw
  {
    std::vector<Eigen::Index> Rows; ///< of the group: "a", "b", "a", ...
    LinearDesign Design;
    std::uint64_t Seed; ///< of the permutations
  };
  /// What is tested: a row per case.
  struct Data
  {
    Eigen::MatrixXd Coefficients;
    Eigen::MatrixXd Moved; ///< along the mean's normal at the points, mm
  };

  Draw NextDraw(const SplitSettings& settings);
  Data DataOf(const Draw& draw) const;
  SplitResult Test(const SplitSettings& settings, const Draw& draw, const Data& data,
                   std::size_t point) const;
  void TestWhereTold(const Draw& draw, const Data& data, const Eigen::VectorXd& shape,
                     SplitResult& result) const;
  Eigen::VectorXd ShapeOfBump(const SurfaceBump& bump) const;
  Vector3 ShiftOf(Eigen::Index row, const Eigen::VectorXd& added) const;
  Eigen::VectorXd MovedBy(const Vector3& shift, Eigen::Index row) const;
  std::size_t PointOf(const SurfaceBump& bump) const;

  CohortGroup Group;
  NormalDisplacement Mean;
  std::vector<Vector3> Directions; ///< of the mean's points
  Eigen::MatrixXd Coefficients;
  std::mt19937_64 Random;
};
} // namespace palpate::test
