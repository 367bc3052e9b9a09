#include "ClusterEnhancement.h"
#include "RandomStudy.h"

#include <queue>

namespace palpate::test
{
namespace
{
using Edges = std::vector<std::pair<int, int>>;

/// A grid of 8 x 8 points joined to their neighbours along the axes.
Edges GridEdges()
{
  Edges edges;
  for (int i = 0; i < 64; ++i)
  {
    if (i % 8 != 7)
    {
      edges.emplace_back(i, i + 1);
    }
    if (i < 56)
    {
      edges.emplace_back(i, i + 8);
    }
  }
  return edges;
}

// The area of the points at or above h that are connected with one, by a search.
double ClusterArea(const Eigen::VectorXd& map, const std::vector<double>& areas, const Edges& edges,
                   int point, double h)
{
  std::vector<bool> isSeen(areas.size(), false);
  std::queue<int> open({point});
  isSeen[static_cast<std::size_t>(point)] = true;
  double area = 0.0;
  while (!open.empty())
  {
    const int at = open.front();
    open.pop();
    area += areas[static_cast<std::size_t>(at)];
    for (const auto& [a, b] : edges)
    {
      const int next = a == at ? b : a;
      if ((a == at || b == at) && map[next] >= h && !isSeen[static_cast<std::size_t>(next)])
      {
        isSeen[static_cast<std::size_t>(next)] = true;
        open.push(next);
      }
    }
  }
  return area;
}

TEST(ClusterEnhancement, IsTheIntegralOverThresholds)
{
  const Edges edges = GridEdges();
  std::vector<double> areas(64);
  std::mt19937 random(3);
  for (double& area : areas)
  {
    area = 0.5 + std::uniform_real_distribution<double>()(random);
  }
  ClusterEnhancement enhancement(areas, edges);
  for (unsigned round = 0; round < 3; ++round)
  {
    const Eigen::VectorXd map = RandomOutcomes(64, 1, 11 + round).col(0);
    Eigen::VectorXd enhanced;
    enhancement.Enhance(map, enhanced);
    for (const int point : {0, 9, 27, 63})
    {
      double integral = 0.0;
      constexpr int Steps = 2000;
      for (int k = 0; k < Steps && map[point] > 0.0; ++k)
      {
        const double h = map[point] * (k + 0.5) / Steps;
        integral +=
            std::sqrt(ClusterArea(map, areas, edges, point, h)) * h * h * map[point] / Steps;
      }
      // A step of the area lies within one of 2,000 thresholds.
      EXPECT_NEAR(enhanced[point], integral, 2e-3 * integral + 1e-12) << point;
    }
  }
}

TEST(ClusterEnhancement, OfASinglePeakIsClosedForm)
{
  ClusterEnhancement enhancement({4.0, 9.0}, {});
  Eigen::VectorXd enhanced;
  enhancement.Enhance(Eigen::Vector2d(3.0, -1.0), enhanced);
  EXPECT_DOUBLE_EQ(enhanced[0], 2.0 * 27.0 / 3.0);
  EXPECT_EQ(enhanced[1], 0.0);
}

TEST(ClusterEnhancement, DoesNotDependOnTheOrderOfPoints)
{
  const Edges edges = GridEdges();
  Edges turned;
  for (const auto& [a, b] : edges)
  {
    turned.emplace_back(63 - b, 63 - a);
  }
  ClusterEnhancement one(std::vector<double>(64, 1.0), edges);
  ClusterEnhancement other(std::vector<double>(64, 1.0), turned);
  // With many equal values.
  const Eigen::VectorXd map =
      RandomOutcomes(64, 1, 5).col(0).unaryExpr([](double x) { return std::round(2.0 * x); });
  Eigen::VectorXd a;
  Eigen::VectorXd b;
  one.Enhance(map, a);
  other.Enhance(map.reverse(), b);
  EXPECT_LT((a - b.reverse()).cwiseAbs().maxCoeff(), 1e-12 * a.maxCoeff());
}
} // namespace
} // namespace palpate::test
