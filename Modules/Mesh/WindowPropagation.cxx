#include "WindowPropagation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Tie = 1e-12;      // of a length: paths that differ by less are equally long
constexpr double Narrowest = 1e-9; // of an edge: narrower windows are left out
constexpr double Nearby = 1e-6;    // of an edge: a start is at its end, or on the edge

double PlaneCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

double AngleAt(const Eigen::Vector2d& apex, double length)
{
  const Eigen::Vector2d toEnd = Eigen::Vector2d(length, 0.0) - apex;
  return std::atan2(PlaneCross(-apex, toEnd), (-apex).dot(toEnd));
}
} // namespace

WindowPropagation::WindowPropagation(const IndexedMesh& mesh)
    : Mesh(mesh), Rings(mesh), EdgeLengths(3 * mesh.Triangles.size()),
      Apexes(3 * mesh.Triangles.size()), Opposite(mesh.Points.size()), Bends(mesh.Points.size()),
      Lengths(mesh.Points.size(), Infinity), Sights(3 * mesh.Triangles.size(), Sight{Infinity, 0.0})
{
  this->Unfold();
  this->FindBends();
}

void WindowPropagation::Unfold()
{
  for (int h = 0; h < static_cast<int>(this->EdgeLengths.size()); ++h)
  {
    const Vector3& start = this->Mesh.Points[StartOf(this->Mesh, h)];
    const Vector3 edge = this->Mesh.Points[StartOf(this->Mesh, NextInTriangle(h))] - start;
    const int apex = StartOf(this->Mesh, PreviousInTriangle(h));
    const Vector3 side = this->Mesh.Points[apex] - start;
    this->EdgeLengths[h] = edge.norm();
    this->Apexes[h] = Plane(side.dot(edge), side.cross(edge).norm()) / this->EdgeLengths[h];
    this->Opposite[apex].push_back(h);
  }
}

// Where the angles around a point are more than a full turn, and at boundaries.
void WindowPropagation::FindBends()
{
  constexpr double FullTurn = 2.0 * M_PI + 1e-8; // rounding of flat parts makes no bends
  std::vector<double> angles(this->Mesh.Points.size());
  for (int h = 0; h < static_cast<int>(this->EdgeLengths.size()); ++h)
  {
    angles[StartOf(this->Mesh, PreviousInTriangle(h))] +=
        AngleAt(this->Apexes[h], this->EdgeLengths[h]);
    if (this->Across(h) < 0)
    {
      this->Bends[StartOf(this->Mesh, h)] = true;
      this->Bends[StartOf(this->Mesh, NextInTriangle(h))] = true;
    }
  }
  for (std::size_t point = 0; point < angles.size(); ++point)
  {
    this->Bends[point] = this->Bends[point] || angles[point] > FullTurn;
  }
}

void WindowPropagation::Reach(int point, double length)
{
  if (length < this->Lengths[point])
  {
    this->ReachedCount += std::isinf(this->Lengths[point]) ? 1 : 0;
    this->Lengths[point] = length;
    if (this->Bends[point])
    {
      this->Open.push({length, -1 - point});
    }
  }
}

void WindowPropagation::StartIn(const NearestOnMesh::Result& from)
{
  const int base = 3 * from.Triangle;
  Vector3 start = from.Point;
  Vector3 middle = Vector3::Zero();
  for (int h = base; h < base + 3; ++h)
  {
    const Vector3& corner = this->Mesh.Points[StartOf(this->Mesh, h)];
    middle += corner / 3.0;
    if ((corner - start).norm() <= Nearby * this->EdgeLengths[h])
    {
      this->Lengths[StartOf(this->Mesh, h)] = 0.0;
      this->StartAt(StartOf(this->Mesh, h));
      return;
    }
  }
  start += Nearby * (middle - start); // off the edges
  for (int h = base; h < base + 3; ++h)
  {
    const Vector3& corner = this->Mesh.Points[StartOf(this->Mesh, h)];
    const Vector3 along =
        (this->Mesh.Points[StartOf(this->Mesh, NextInTriangle(h))] - corner).normalized();
    const Plane place((start - corner).dot(along), (start - corner).cross(along).norm());
    this->Reach(StartOf(this->Mesh, h), (start - corner).norm());
    this->Add({this->Across(h), -1, 0.0, this->EdgeLengths[h], this->Turned(h, place), 0.0});
  }
}

void WindowPropagation::StartAt(int point)
{
  const double length = this->Lengths[point];
  for (const int h : this->Opposite[point])
  {
    this->Reach(StartOf(this->Mesh, h), length + this->EdgeLengths[PreviousInTriangle(h)]);
    this->Reach(StartOf(this->Mesh, NextInTriangle(h)),
                length + this->EdgeLengths[NextInTriangle(h)]);
    this->Add(
        {this->Across(h), -1, 0.0, this->EdgeLengths[h], this->Turned(h, this->Apexes[h]), length});
  }
}

// A way over one of the points of the triangle behind it is shorter for all of the window.
bool WindowPropagation::IsUseless(const Window& window) const
{
  const int h = window.HalfEdge;
  const double first = window.Offset + (Plane(window.First, 0.0) - window.Source).norm();
  const double last = window.Offset + (Plane(window.Last, 0.0) - window.Source).norm();
  const double keep = 1.0 - Tie;
  const int start = StartOf(this->Mesh, h);
  const int end = StartOf(this->Mesh, NextInTriangle(h));
  if (this->Lengths[start] + window.Last < keep * last ||
      this->Lengths[end] + this->EdgeLengths[h] - window.First < keep * first)
  {
    return true;
  }
  if (window.Behind < 0)
  {
    return false;
  }
  const int other = this->Across(h);
  const Plane apex = this->Turned(other, this->Apexes[other]);
  const double near = window.Behind == 0 ? window.First : window.Last;
  return this->Lengths[StartOf(this->Mesh, PreviousInTriangle(other))] +
             (apex - Plane(near, 0.0)).norm() <
         keep * (window.Behind == 0 ? first : last);
}

void WindowPropagation::Add(const Window& window)
{
  if (window.HalfEdge < 0 ||
      !(window.Last - window.First > Narrowest * this->EdgeLengths[window.HalfEdge]) ||
      this->IsUseless(window))
  {
    return;
  }
  const double nearest = std::clamp(window.Source[0], window.First, window.Last);
  const double least = window.Offset + (Plane(nearest, 0.0) - window.Source).norm();
  if (!std::isfinite(least))
  {
    return;
  }
  if (this->Free.empty())
  {
    this->Free.push_back(static_cast<int>(this->Windows.size()));
    this->Windows.emplace_back();
  }
  this->Windows[this->Free.back()] = window;
  this->Open.push({least, this->Free.back()});
  this->Free.pop_back();
}

// The edge from `start` (in the window's frame) in the direction of `left`, the half-edge on its
// other side; whether the window's part begins at the edge's start and ends at its end.
void WindowPropagation::AddBeyond(const Window& window, int left, const Plane& start, bool first,
                                  bool last)
{
  const bool isRight = left == NextInTriangle(window.HalfEdge);
  const int other = this->Across(left);
  if (other < 0)
  {
    return;
  }
  const Plane apex = this->Apexes[window.HalfEdge];
  const Plane end = isRight ? Plane(this->EdgeLengths[window.HalfEdge], 0.0) : apex;
  const double length = this->EdgeLengths[left];
  const Plane along = (end - start) / length;
  const auto inFrame = [&](const Plane& place)
  { return Plane((place - start).dot(along), PlaneCross(along, place - start)); };
  const Plane source = inFrame(window.Source);
  const auto hit = [&](double through)
  {
    const Plane base = inFrame({through, 0.0});
    const double rise = base[1] - source[1];
    const double place =
        rise > 0.0 ? source[0] - (base[0] - source[0]) * source[1] / rise : base[0];
    return std::clamp(place, 0.0, length);
  };
  this->Add({other, isRight ? 1 : 0, first ? 0.0 : hit(window.First),
             last ? length : hit(window.Last), source, window.Offset});
}

void WindowPropagation::AddRight(const Window& window, bool seesApex)
{
  this->AddBeyond(window, NextInTriangle(window.HalfEdge), this->Apexes[window.HalfEdge], seesApex,
                  false);
}

void WindowPropagation::AddLeft(const Window& window, bool seesApex)
{
  this->AddBeyond(window, PreviousInTriangle(window.HalfEdge), Plane::Zero(), false, seesApex);
}

void WindowPropagation::Propagate(const Window& window)
{
  const Plane& apex = this->Apexes[window.HalfEdge];
  const Plane toApex = apex - window.Source;
  const double slack = Tie * toApex.norm() * this->EdgeLengths[window.HalfEdge];
  if (PlaneCross(Plane(window.First, 0.0) - window.Source, toApex) > slack)
  {
    this->AddRight(window, false);
    return;
  }
  if (PlaneCross(Plane(window.Last, 0.0) - window.Source, toApex) < -slack)
  {
    this->AddLeft(window, false);
    return;
  }
  const Sight sight{window.Offset + toApex.norm(),
                    window.Source[0] - toApex[0] * window.Source[1] / toApex[1]};
  this->Reach(StartOf(this->Mesh, PreviousInTriangle(window.HalfEdge)), sight.Length);
  // A window with a longer way to the apex is of use on one side only: on the other one its lines
  // cross that of the shorter way ("one angle, one split"). Equal ways can be one through a point.
  Sight& best = this->Sights[window.HalfEdge];
  const bool isAsGood = sight.Length <= best.Length * (1.0 + Tie);
  if (isAsGood || sight.Place <= best.Place)
  {
    this->AddLeft(window, true);
  }
  if (isAsGood || sight.Place > best.Place)
  {
    this->AddRight(window, true);
  }
  if (sight.Length < best.Length)
  {
    best = sight;
  }
}

bool WindowPropagation::Run(const NearestOnMesh::Result& from, const KernelProgress& progress)
{
  constexpr std::size_t Batch = 4096;
  this->StartIn(from);
  for (std::size_t count = 0; !this->Open.empty(); ++count)
  {
    const auto [least, number] = this->Open.top();
    this->Open.pop();
    if (number < 0)
    {
      if (!(least > this->Lengths[-1 - number]))
      {
        this->StartAt(-1 - number);
      }
    }
    else
    {
      const Window window = this->Windows[number];
      this->Free.push_back(number);
      if (!this->IsUseless(window))
      {
        this->Propagate(window);
      }
    }
    const double done = static_cast<double>(this->ReachedCount) / this->Lengths.size();
    if (count % Batch == 0 && progress && !progress(done))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
