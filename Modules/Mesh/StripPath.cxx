#include "StripPath.h"

#include "EdgeRings.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using UnfoldedPoint = Eigen::Vector2d;

double Cross(const UnfoldedPoint& a, const UnfoldedPoint& b) noexcept
{
  return a.x() * b.y() - a.y() * b.x();
}

// Positive if c is to the left of the line from a to b.
double Turn(const UnfoldedPoint& a, const UnfoldedPoint& b, const UnfoldedPoint& c) noexcept
{
  return Cross(b - a, c - a);
}

// A crossed edge, unfolded. Right is where its half-edge starts, as seen by the path.
struct Portal
{
  UnfoldedPoint Left;
  UnfoldedPoint Right;
  int LeftPoint;
  int RightPoint;
};

// Place of a point of the triangle on the near (1) or far (-1) side of an unfolded edge.
UnfoldedPoint Unfold(const IndexedMesh& mesh, const Portal& edge, const Vector3& point, double side)
{
  const Vector3& start = mesh.Points[edge.RightPoint];
  const Vector3 along = (mesh.Points[edge.LeftPoint] - start).normalized();
  const Vector3 arm = point - start;
  const double x = arm.dot(along);
  const double y = side * (arm - x * along).norm();
  const UnfoldedPoint unit = (edge.Left - edge.Right).normalized();
  return edge.Right + x * unit + y * UnfoldedPoint(-unit.y(), unit.x());
}

std::vector<Portal> UnfoldStrip(const IndexedMesh& mesh, const std::vector<int>& crossed,
                                const std::vector<int>& entered)
{
  std::vector<Portal> portals;
  portals.reserve(crossed.size() + 1);
  const int start = StartOf(mesh, crossed.front());
  const int end = StartOf(mesh, NextInTriangle(crossed.front()));
  const double length = (mesh.Points[end] - mesh.Points[start]).norm();
  portals.push_back({UnfoldedPoint(length, 0.0), UnfoldedPoint::Zero(), end, start});
  for (std::size_t i = 1; i < crossed.size(); ++i)
  {
    // The next edge joins an end of the last one to the opposite corner.
    Portal next = portals.back();
    const int apex = StartOf(mesh, PreviousInTriangle(entered[i - 1]));
    const UnfoldedPoint place = Unfold(mesh, next, mesh.Points[apex], -1.0);
    const bool keepsLeft = StartOf(mesh, crossed[i]) == next.LeftPoint ||
                           StartOf(mesh, NextInTriangle(crossed[i])) == next.LeftPoint;
    (keepsLeft ? next.Right : next.Left) = place;
    (keepsLeft ? next.RightPoint : next.LeftPoint) = apex;
    portals.push_back(next);
  }
  return portals;
}

// A place of the path where it may bend; Crossing is -1 at its start.
struct Corner
{
  UnfoldedPoint At;
  int Point;
  int Crossing;
};

// Narrows a side of the funnel to `place`, unless that is wider. Where the path would leave the
// funnel on its other side, returns that, as it has to bend there; else null. `sign` is 1 for the
// right side, -1 for the left one.
const Corner* Narrow(const UnfoldedPoint& apex, Corner& side, const Corner& other,
                     const Corner& place, double sign)
{
  if (sign * Turn(apex, side.At, place.At) < 0.0)
  {
    return nullptr;
  }
  if (side.At != apex && sign * Turn(apex, other.At, place.At) >= 0.0)
  {
    return &other;
  }
  side = place;
  return nullptr;
}

// The last portal is the end of the path.
std::vector<Corner> PullTight(const std::vector<Portal>& portals, const UnfoldedPoint& from)
{
  std::vector<Corner> bends{{from, -1, -1}};
  Corner left = bends.back();
  Corner right = bends.back();
  for (int i = 0; i < static_cast<int>(portals.size()); ++i)
  {
    const Portal& portal = portals[i];
    const UnfoldedPoint apex = bends.back().At;
    const Corner* bend = Narrow(apex, right, left, {portal.Right, portal.RightPoint, i}, 1.0);
    if (bend == nullptr)
    {
      bend = Narrow(apex, left, right, {portal.Left, portal.LeftPoint, i}, -1.0);
    }
    if (bend != nullptr)
    {
      bends.push_back(*bend);
      left = right = bends.back();
      i = bends.back().Crossing;
    }
  }
  bends.push_back({portals.back().Left, -1, static_cast<int>(portals.size()) - 1});
  return bends;
}

// Fraction of an edge, from its right end, at which the line between two bends crosses it.
double CrossingOf(const Portal& portal, const UnfoldedPoint& from, const UnfoldedPoint& to)
{
  const UnfoldedPoint edge = portal.Left - portal.Right;
  const UnfoldedPoint line = to - from;
  const double across = Cross(edge, line);
  const double fraction = across != 0.0 ? Cross(from - portal.Right, line) / across : 0.0;
  return std::clamp(fraction, 0.0, 1.0);
}
// Adds the bends at corners, those that follow each other at one corner as one.
void AddPivots(const std::vector<Corner>& bends, StripPath& path)
{
  for (const Corner& bend : bends)
  {
    if (bend.Point >= 0 && !path.Pivots.empty() && path.Pivots.back().Point == bend.Point)
    {
      path.Pivots.back().Crossing = bend.Crossing;
    }
    else if (bend.Point >= 0)
    {
      path.Pivots.push_back({bend.Point, bend.Crossing});
    }
  }
}
} // namespace

StripPath FindStripPath(const IndexedMesh& mesh, const std::vector<int>& crossed,
                        const std::vector<int>& entered, const Vector3& from, const Vector3& to)
{
  StripPath path;
  path.Points = {from};
  if (!crossed.empty())
  {
    std::vector<Portal> portals = UnfoldStrip(mesh, crossed, entered);
    const UnfoldedPoint start = Unfold(mesh, portals.front(), from, 1.0);
    const UnfoldedPoint end = Unfold(mesh, portals.back(), to, -1.0);
    portals.push_back({end, end, -1, -1});
    const std::vector<Corner> bends = PullTight(portals, start);
    for (std::size_t b = 1; b < bends.size(); ++b)
    {
      const int last = std::min(bends[b].Crossing, static_cast<int>(crossed.size()) - 1);
      for (int i = bends[b - 1].Crossing + 1; i <= last; ++i)
      {
        const double fraction = CrossingOf(portals[i], bends[b - 1].At, bends[b].At);
        const Vector3& right = mesh.Points[portals[i].RightPoint];
        path.Points.push_back(right + fraction * (mesh.Points[portals[i].LeftPoint] - right));
      }
    }
    AddPivots(bends, path);
  }
  path.Points.push_back(to);
  for (std::size_t i = 1; i < path.Points.size(); ++i)
  {
    path.Length += (path.Points[i] - path.Points[i - 1]).norm();
  }
  return path;
}
} // namespace palpate
