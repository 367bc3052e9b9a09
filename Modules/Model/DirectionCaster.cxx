#include "DirectionCaster.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::size_t FaceCount = 6;
// The largest angle between a cube face's axis and a direction that belongs to the face.
const double CornerCosine = 1.0 / std::sqrt(3.0);

// Face 2a is on the +a axis, face 2a + 1 on the -a axis.
Vector3 FaceAxis(std::size_t face)
{
  Vector3 axis = Vector3::Zero();
  axis[static_cast<Eigen::Index>(face / 2)] = face % 2 == 0 ? 1.0 : -1.0;
  return axis;
}

struct FacePoint
{
  double U;
  double V;
};

// Central projection onto the face's plane; the face is [-1, 1]^2.
FacePoint Project(std::size_t face, const Vector3& p)
{
  const auto a = static_cast<Eigen::Index>(face / 2);
  const double w = std::abs(p[a]);
  return {p[(a + 1) % 3] / w, p[(a + 2) % 3] / w};
}

std::size_t FaceOf(const Vector3& direction)
{
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(axis) * 2 + (direction[axis] < 0.0 ? 1 : 0);
}

int CellAlong(double coordinate, int cells)
{
  return std::clamp(static_cast<int>(0.5 * (coordinate + 1.0) * cells), 0, cells - 1);
}

// d . (p x q), with the operands in the same order for both triangles of an edge.
double EdgeSide(const Vector3& d, const Vector3& p, const Vector3& q, bool inOrder)
{
  return inOrder ? d.dot(p.cross(q)) : -d.dot(q.cross(p));
}
} // namespace

DirectionCaster::DirectionCaster(const std::vector<Vector3>& directions)
    : CellsPerSide(std::max(
          1, static_cast<int>(std::sqrt(static_cast<double>(directions.size()) / FaceCount))))
{
  // Far above rounding (1e-16), far below the accuracy of any result.
  const Vector3 turn = 1e-11 * Vector3(0.577, 0.211, 0.789);
  this->Directions.reserve(directions.size());
  for (const Vector3& direction : directions)
  {
    this->Directions.push_back((direction + turn).normalized());
  }
  const auto cells = static_cast<std::size_t>(this->CellsPerSide);
  std::vector<std::size_t> cellOf;
  cellOf.reserve(directions.size());
  this->CellStart.assign(FaceCount * cells * cells + 1, 0);
  for (const Vector3& direction : this->Directions)
  {
    const std::size_t face = FaceOf(direction);
    const FacePoint point = Project(face, direction);
    const auto u = static_cast<std::size_t>(CellAlong(point.U, this->CellsPerSide));
    const auto v = static_cast<std::size_t>(CellAlong(point.V, this->CellsPerSide));
    cellOf.push_back((face * cells + v) * cells + u);
    ++this->CellStart[cellOf.back() + 1];
  }
  for (std::size_t c = 1; c < this->CellStart.size(); ++c)
  {
    this->CellStart[c] += this->CellStart[c - 1];
  }
  this->Order.resize(directions.size());
  std::vector<std::size_t> next(this->CellStart.begin(), this->CellStart.end() - 1);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    this->Order[next[cellOf[i]]++] = i;
  }
}

template <typename Visit>
void DirectionCaster::VisitFace(std::size_t face, const std::array<Vector3, 3>& corners,
                                const Visit& visit) const
{
  const Vector3 axis = FaceAxis(face);
  int ahead = 0;
  for (const Vector3& corner : corners)
  {
    ahead += corner.dot(axis) > 0.0 ? 1 : 0;
  }
  if (ahead == 0)
  {
    return;
  }
  double low[2] = {-1.0, -1.0};
  double high[2] = {1.0, 1.0};
  if (ahead == 3)
  {
    low[0] = low[1] = 1e300;
    high[0] = high[1] = -1e300;
    for (const Vector3& corner : corners)
    {
      const FacePoint point = Project(face, corner);
      low[0] = std::min(low[0], point.U);
      high[0] = std::max(high[0], point.U);
      low[1] = std::min(low[1], point.V);
      high[1] = std::max(high[1], point.V);
    }
    // The rotation of the directions may move one just over a bound.
    if (low[0] > 1.0 + 1e-9 || low[1] > 1.0 + 1e-9 || high[0] < -1.0 - 1e-9 ||
        high[1] < -1.0 - 1e-9)
    {
      return;
    }
  }
  const int firstU = CellAlong(low[0] - 1e-9, this->CellsPerSide);
  const int lastU = CellAlong(high[0] + 1e-9, this->CellsPerSide);
  const int firstV = CellAlong(low[1] - 1e-9, this->CellsPerSide);
  const int lastV = CellAlong(high[1] + 1e-9, this->CellsPerSide);
  const auto cells = static_cast<std::size_t>(this->CellsPerSide);
  for (int v = firstV; v <= lastV; ++v)
  {
    const std::size_t row = (face * cells + static_cast<std::size_t>(v)) * cells;
    const std::size_t first = this->CellStart[row + static_cast<std::size_t>(firstU)];
    const std::size_t last = this->CellStart[row + static_cast<std::size_t>(lastU) + 1];
    for (std::size_t at = first; at < last; ++at)
    {
      visit(this->Order[at]);
    }
  }
}

template <typename Visit>
void DirectionCaster::ForEachCrossing(const IndexedMesh& mesh, const Vector3& center,
                                      const Visit& visit) const
{
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::array<int, 3>& ids = mesh.Triangles[t];
    const std::array<Vector3, 3> p{mesh.Points[static_cast<std::size_t>(ids[0])] - center,
                                   mesh.Points[static_cast<std::size_t>(ids[1])] - center,
                                   mesh.Points[static_cast<std::size_t>(ids[2])] - center};
    const double determinant = p[0].dot(p[1].cross(p[2]));
    const auto test = [&](std::size_t index)
    {
      const Vector3& d = this->Directions[index];
      const double e0 = EdgeSide(d, p[1], p[2], ids[1] < ids[2]);
      const double e1 = EdgeSide(d, p[2], p[0], ids[2] < ids[0]);
      const double e2 = EdgeSide(d, p[0], p[1], ids[0] < ids[1]);
      const bool front = e0 > 0.0 && e1 > 0.0 && e2 > 0.0;
      const bool back = e0 <= 0.0 && e1 <= 0.0 && e2 <= 0.0;
      const double sum = e0 + e1 + e2;
      if ((front || back) && sum != 0.0)
      {
        const double distance = determinant / sum;
        if (distance > 0.0)
        {
          visit(index, static_cast<int>(t), distance);
        }
      }
    };
    // A triangle whose directions all lie further from a face's axis than the face's corners
    // cannot meet the face.
    const Vector3 axis = (p[0].normalized() + p[1].normalized() + p[2].normalized()).normalized();
    double cosine = 1.0;
    for (const Vector3& corner : p)
    {
      cosine = std::min(cosine, axis.dot(corner.normalized()));
    }
    const bool small = cosine > 0.0;
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double cornerSine = std::sqrt(1.0 - CornerCosine * CornerCosine);
    const double reach = CornerCosine * cosine - cornerSine * sine;
    for (std::size_t face = 0; face < FaceCount; ++face)
    {
      if (!small || axis.dot(FaceAxis(face)) >= reach - 1e-9)
      {
        this->VisitFace(face, p, test);
      }
    }
  }
}

std::vector<std::vector<RayCrossing>> DirectionCaster::Cast(const IndexedMesh& mesh,
                                                            const Vector3& center) const
{
  std::vector<std::vector<RayCrossing>> crossings(this->Directions.size());
  this->ForEachCrossing(mesh, center,
                        [&crossings](std::size_t index, int triangle, double distance) {
                          crossings[index].push_back({triangle, distance});
                        });
  for (std::vector<RayCrossing>& list : crossings)
  {
    std::sort(list.begin(), list.end(),
              [](const RayCrossing& a, const RayCrossing& b) {
                return a.Distance != b.Distance ? a.Distance < b.Distance : a.Triangle < b.Triangle;
              });
  }
  return crossings;
}

std::vector<int> DirectionCaster::CountNearer(const IndexedMesh& mesh, const Vector3& center,
                                              const std::vector<int>& ownTriangle,
                                              const std::vector<double>& distance) const
{
  std::vector<int> nearer(this->Directions.size(), 0);
  this->ForEachCrossing(mesh, center,
                        [&](std::size_t index, int triangle, double found)
                        {
                          if (triangle != ownTriangle[index] && found < distance[index])
                          {
                            ++nearer[index];
                          }
                        });
  return nearer;
}
} // namespace palpate
