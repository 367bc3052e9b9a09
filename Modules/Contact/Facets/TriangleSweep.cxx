#include "TriangleSweep.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Motion along a touched plane approaches it only by rounding.
bool ComesNearer(const Vector3& normal, const Vector3& path) noexcept
{
  return normal.dot(path) < -1e-12 * normal.norm() * path.norm();
}

void Record(double part, const Vector3& normal, const Vector3& path, SweepHit& hit) noexcept
{
  if (part < hit.Part && ComesNearer(normal, path))
  {
    hit = {part, normal, 0.0, true};
  }
}

// The smaller root of a t^2 + 2 b t + c; NaN without one.
double FirstRoot(double a, double b, double c) noexcept
{
  return (-b - std::sqrt(b * b - a * c)) / a;
}

void SweepCorner(const SphereMotion& motion, const Vector3& corner, SweepHit& hit) noexcept
{
  const Vector3 m = motion.Start - corner;
  const double part = FirstRoot(motion.Path.squaredNorm(), m.dot(motion.Path),
                                m.squaredNorm() - motion.Radius * motion.Radius);
  if (part >= 0.0 && part < hit.Part)
  {
    Record(part, (m + part * motion.Path).normalized(), motion.Path, hit);
  }
}

void SweepEdge(const SphereMotion& motion, const Vector3& from, const Vector3& to,
               SweepHit& hit) noexcept
{
  const Vector3 edge = to - from;
  const double square = edge.squaredNorm();
  // Perpendicular to the edge it is the same as for a corner.
  const Vector3 m = motion.Start - from;
  const double start = m.dot(edge) / square;
  const double rate = motion.Path.dot(edge) / square;
  const Vector3 across = m - start * edge;
  const Vector3 path = motion.Path - rate * edge;
  const double part = FirstRoot(path.squaredNorm(), across.dot(path),
                                across.squaredNorm() - motion.Radius * motion.Radius);
  const double place = start + part * rate;
  if (part >= 0.0 && part < hit.Part && place >= 0.0 && place <= 1.0)
  {
    Record(part, (across + part * path).normalized(), motion.Path, hit);
  }
}

bool IsInFacet(const Vector3& point, const Facet& facet) noexcept
{
  return (facet.B - facet.A).cross(point - facet.A).dot(facet.Normal) >= 0.0 &&
         (facet.C - facet.B).cross(point - facet.B).dot(facet.Normal) >= 0.0 &&
         (facet.A - facet.C).cross(point - facet.C).dot(facet.Normal) >= 0.0;
}

// Returns true if the face is touched first, or no part of the facet can be.
bool SweepFace(const SphereMotion& motion, const Facet& facet, SweepHit& hit) noexcept
{
  const Vector3& normal = facet.Normal;
  const double height = normal.dot(motion.Start - facet.A);
  const double side = height >= 0.0 ? 1.0 : -1.0;
  const double gap = std::abs(height) - motion.Radius;
  const double speed = -side * normal.dot(motion.Path);
  if (gap > 0.0 && !(speed * hit.Part > gap))
  {
    return true; // the plane is not reached
  }
  const double part = gap / speed;
  const Vector3 touched = motion.Start + part * motion.Path - side * motion.Radius * normal;
  if (gap > 0.0 && IsInFacet(touched, facet))
  {
    Record(part, side * normal, motion.Path, hit);
    return true;
  }
  return false;
}
} // namespace

Vector3 ClosestPointOnFacet(const Vector3& point, const Facet& facet) noexcept
{
  const Vector3 ab = facet.B - facet.A;
  const Vector3 ac = facet.C - facet.A;
  const Vector3 ap = point - facet.A;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return facet.A;
  }
  const Vector3 bp = point - facet.B;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return facet.B;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return facet.A + (d1 / (d1 - d3)) * ab;
  }
  const Vector3 cp = point - facet.C;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return facet.C;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return facet.A + (d2 / (d2 - d6)) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  const double alongB = d4 - d3;
  const double alongC = d5 - d6;
  if (va <= 0.0 && alongB >= 0.0 && alongC >= 0.0)
  {
    return facet.B + (alongB / (alongB + alongC)) * (facet.C - facet.B);
  }
  const double sum = va + vb + vc;
  return facet.A + (vb / sum) * ab + (vc / sum) * ac;
}

namespace
{
void SweepFacet(const SphereMotion& motion, const Facet& facet, SweepHit& hit) noexcept
{
  if (SweepFace(motion, facet, hit))
  {
    return;
  }
  const Vector3 offset = motion.Start - ClosestPointOnFacet(motion.Start, facet);
  const double distance = offset.norm();
  // A sphere that was stopped here before touches up to rounding, and roots might lie behind it.
  if (distance <= (1.0 + 1e-6) * motion.Radius)
  {
    const double overlap = std::max(0.0, motion.Radius - distance);
    const bool isFirst = hit.Part > 0.0 || overlap > hit.Overlap;
    if (distance > 0.0 && isFirst && ComesNearer(offset, motion.Path))
    {
      hit = {0.0, offset / distance, overlap, true};
    }
    return;
  }
  SweepEdge(motion, facet.A, facet.B, hit);
  SweepEdge(motion, facet.B, facet.C, hit);
  SweepEdge(motion, facet.C, facet.A, hit);
  SweepCorner(motion, facet.A, hit);
  SweepCorner(motion, facet.B, hit);
  SweepCorner(motion, facet.C, hit);
}

// Between two segments, squared (Ericson, Real-Time Collision Detection, 2005, ch. 5).
double SquaredGap(const Vector3& from, const Vector3& path, const Vector3& start,
                  const Vector3& edge) noexcept
{
  const Vector3 between = from - start;
  const double a = path.squaredNorm();
  const double b = path.dot(edge);
  const double e = edge.squaredNorm();
  const double c = path.dot(between);
  const double f = edge.dot(between);
  const double denominator = a * e - b * b;
  double s = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  const double t = std::clamp((b * s + f) / e, 0.0, 1.0);
  s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
  return (between + s * path - t * edge).squaredNorm();
}

// Whether the whole path, which stays on one side of the facet, enters it by no more than the
// slack.
bool OnlyGrazes(const SphereMotion& motion, const Facet& facet, const Vector3& normal) noexcept
{
  constexpr double Steepest = 0.5;
  const Vector3 end = motion.Start + motion.Path;
  const double side = facet.Normal.dot(motion.Start - facet.A);
  if (!(motion.Slack > 0.0) || -normal.dot(motion.Path) > Steepest * motion.Path.norm() ||
      side * facet.Normal.dot(end - facet.A) <= 0.0)
  {
    return false;
  }
  const double least = motion.Radius - motion.Slack;
  const double square = least * least;
  return (end - ClosestPointOnFacet(end, facet)).squaredNorm() >= square &&
         SquaredGap(motion.Start, motion.Path, facet.A, facet.B - facet.A) >= square &&
         SquaredGap(motion.Start, motion.Path, facet.B, facet.C - facet.B) >= square &&
         SquaredGap(motion.Start, motion.Path, facet.C, facet.A - facet.C) >= square;
}
} // namespace

void SweepSphere(const SphereMotion& motion, const Facet& facet, SweepHit& hit) noexcept
{
  SweepHit found = hit;
  SweepFacet(motion, facet, found);
  const bool isNearer = found.Part < hit.Part || found.Overlap > hit.Overlap || !hit.IsHit;
  if (found.IsHit && isNearer && !OnlyGrazes(motion, facet, found.Normal))
  {
    hit = found;
  }
}
} // namespace palpate
