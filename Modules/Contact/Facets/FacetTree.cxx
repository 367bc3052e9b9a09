#include "FacetTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double FarFromFacets = std::numeric_limits<double>::infinity();

Eigen::AlignedBox3d BoxOf(const Facet& facet)
{
  Eigen::AlignedBox3d box(facet.A);
  box.extend(facet.B);
  box.extend(facet.C);
  return box;
}

// The fraction of the path at which the sphere first meets the box; infinite if not within [0,
// last].
double PartToBox(const SphereMotion& motion, const Vector3& inverse, const Eigen::AlignedBox3d& box,
                 double last) noexcept
{
  double first = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.min()[axis] - motion.Radius - motion.Start[axis];
    const double high = box.max()[axis] + motion.Radius - motion.Start[axis];
    if (motion.Path[axis] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return FarFromFacets;
      }
      continue;
    }
    const double a = low * inverse[axis];
    const double b = high * inverse[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last ? first : FarFromFacets;
}

// Calls leaf(number) for the facets of all nodes whose bound(box) isOpen. A pending node keeps its
// bound, and of two children the one with the smaller bound is visited first.
template <typename Bound, typename IsOpen, typename Leaf>
void Visit(const BoxHierarchy& boxes, const Bound& bound, const IsOpen& isOpen,
           const Leaf& leaf) noexcept
{
  struct Pending
  {
    std::int32_t Number;
    double Least;
  };
  const auto nodeAt = [&boxes](std::int32_t number) -> const BoxHierarchy::Node&
  { return boxes.Nodes()[static_cast<std::size_t>(number)]; };
  Pending pending[BoxHierarchy::MostPending];
  int count = 0;
  pending[count++] = {0, bound(nodeAt(0).Box)};
  while (count > 0)
  {
    const Pending next = pending[--count];
    if (!isOpen(next.Least))
    {
      continue;
    }
    const BoxHierarchy::Node& node = nodeAt(next.Number);
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      leaf(static_cast<std::size_t>(i));
    }
    if (node.Count == 0)
    {
      Pending near{next.Number + 1, bound(nodeAt(next.Number + 1).Box)};
      Pending far{node.Second, bound(nodeAt(node.Second).Box)};
      if (far.Least < near.Least)
      {
        std::swap(near, far);
      }
      pending[count++] = far;
      pending[count++] = near;
    }
  }
}

bool HasArea(const Facet& facet)
{
  const Vector3 ab = facet.B - facet.A;
  const Vector3 ac = facet.C - facet.A;
  // A smaller cross product of parallel edges is rounding.
  return ab.cross(ac).norm() > 1e-14 * ab.norm() * ac.norm() && (facet.C - facet.B).norm() > 0.0;
}
} // namespace

Status FacetTree::Make(const std::vector<Vector3>& pointsWorld,
                       const std::vector<Triangle>& triangles,
                       std::shared_ptr<const FacetTree>& tree)
{
  if (!std::all_of(pointsWorld.begin(), pointsWorld.end(),
                   [](const Vector3& p) { return p.allFinite(); }))
  {
    return Status::Failure("The mesh to be touched has points that are not finite.");
  }
  const int count = static_cast<int>(pointsWorld.size());
  std::vector<Facet> facets;
  for (const Triangle& t : triangles)
  {
    if (!std::all_of(t.begin(), t.end(), [count](int p) { return p >= 0 && p < count; }))
    {
      return Status::Failure("The mesh to be touched has triangles with invalid point indices.");
    }
    const auto corner = [&](std::size_t n) { return pointsWorld[static_cast<std::size_t>(t[n])]; };
    const Facet facet(corner(0), corner(1), corner(2));
    if (HasArea(facet))
    {
      facets.push_back(facet);
    }
  }
  if (facets.empty())
  {
    return Status::Failure("The mesh to be touched has no triangle with a positive area.");
  }
  const std::shared_ptr<FacetTree> made(new FacetTree);
  std::vector<Eigen::AlignedBox3d> boxes(facets.size());
  std::transform(facets.begin(), facets.end(), boxes.begin(), BoxOf);
  made->Boxes = BoxHierarchy(boxes);
  made->Facets.reserve(facets.size());
  for (const std::uint32_t number : made->Boxes.Order())
  {
    made->Facets.push_back(facets[number]);
  }
  tree = made;
  return Status::Success();
}

FacetTree::Nearest FacetTree::NearestTo(const Vector3& pointWorld, double within) const noexcept
{
  double least = within * within;
  Nearest nearest;
  nearest.Distance = FarFromFacets;
  Visit(
      this->Boxes,
      [&](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(pointWorld); },
      [&](double square) { return square <= least; },
      [&](std::size_t i)
      {
        const Vector3 point = ClosestPointOnFacet(pointWorld, this->Facets[i]);
        const double square = (point - pointWorld).squaredNorm();
        if (square <= least)
        {
          least = square;
          nearest = {point, std::sqrt(square)};
        }
      });
  return nearest;
}

// The path is clipped to the box of the whole mesh: from far away, roots would have too few digits.
SweepHit FacetTree::Sweep(const SphereMotion& motion) const noexcept
{
  const double before =
      PartToBox(motion, motion.Path.cwiseInverse(), this->Boxes.Nodes().front().Box, 1.0);
  if (!(before <= 1.0))
  {
    return {};
  }
  SweepHit hit = this->SweepNear({motion.Start + before * motion.Path, (1.0 - before) * motion.Path,
                                  motion.Radius, motion.Slack});
  hit.Part = before + hit.Part * (1.0 - before);
  return hit;
}

SweepHit FacetTree::SweepNear(const SphereMotion& motion) const noexcept
{
  const Vector3 inverse = motion.Path.cwiseInverse();
  SweepHit hit;
  Visit(
      this->Boxes,
      [&](const Eigen::AlignedBox3d& box) { return PartToBox(motion, inverse, box, hit.Part); },
      [&](double part) { return part < hit.Part; },
      [&](std::size_t i) { SweepSphere(motion, this->Facets[i], hit); });
  return hit;
}

bool FacetTree::IsInside(const Vector3& pointWorld) const noexcept
{
  if (!this->BoundsWorld().contains(pointWorld))
  {
    return false;
  }
  // Three directions that are unlikely to be parallel to any edge: one ray may meet an edge.
  int votes = 0;
  for (const Vector3& direction :
       {Vector3(0.5257311, 0.3090170, 0.7936204), Vector3(-0.7936204, 0.5257311, 0.3090170),
        Vector3(0.3090170, -0.7936204, 0.5257311)})
  {
    votes += this->CrossesOddly(pointWorld, direction) ? 1 : 0;
  }
  return votes > 1;
}

// Whether a ray crosses the mesh an odd number of times.
bool FacetTree::CrossesOddly(const Vector3& start, const Vector3& direction) const noexcept
{
  const SphereMotion ray{start, direction, 0.0};
  const Vector3 inverse = direction.cwiseInverse();
  bool isOdd = false;
  Visit(
      this->Boxes,
      [&](const Eigen::AlignedBox3d& box) { return PartToBox(ray, inverse, box, FarFromFacets); },
      [](double part) { return part < FarFromFacets; },
      [&](std::size_t i)
      {
        const Facet& facet = this->Facets[i];
        const Vector3 ab = facet.B - facet.A;
        const Vector3 ac = facet.C - facet.A;
        const Vector3 p = direction.cross(ac);
        const double determinant = ab.dot(p);
        const Vector3 offset = start - facet.A;
        const double u = offset.dot(p) / determinant;
        const Vector3 q = offset.cross(ab);
        const double v = direction.dot(q) / determinant;
        const bool isCrossed =
            u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(q) / determinant > 0.0;
        isOdd = isOdd != isCrossed;
      });
  return isOdd;
}
} // namespace palpate
