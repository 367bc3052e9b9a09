#include "StarMesh.h"

#include "HexahedronShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using Lattice = std::array<int, 3>;

constexpr double QuarterTurn = 0.78539816339744831; // rad, from a cube's face centre to its edge

// Of a point on the cube: equal angles along the great circles through the faces' centres.
Vector3 EquiangularPoint(const Vector3& onCube) noexcept
{
  return (QuarterTurn * onCube).array().tan();
}

// A cube of half the ball's size, rounded, so that elements have similar sizes everywhere.
Vector3 InMiddle(const Vector3& inCube) noexcept
{
  constexpr double Size = 0.5;
  constexpr double Round = 1.2;
  const double largest = inCube.cwiseAbs().maxCoeff();
  if (!(largest > 0.0))
  {
    return Vector3::Zero();
  }
  const Vector3 direction = EquiangularPoint(inCube / largest).normalized();
  return 0.5 * Size * (inCube + Round * largest * direction);
}

// Points of the unit ball and the elements between them.
class CubedBall
{
public:
  explicit CubedBall(int n) : Across(n), Layers(n / 2) { this->Number(); }

  std::vector<StarMesh::Place> Places() const
  {
    std::vector<StarMesh::Place> places;
    for (int k = 0; k <= this->Across; ++k)
    {
      for (int j = 0; j <= this->Across; ++j)
      {
        for (int i = 0; i <= this->Across; ++i)
        {
          places.push_back({i, j, k, 0});
        }
      }
    }
    for (int layer = 1; layer <= this->Layers; ++layer)
    {
      for (const Lattice& place : this->Outer)
      {
        places.push_back({place[0], place[1], place[2], layer});
      }
    }
    return places;
  }

  Vector3 Point(const StarMesh::Place& place) const
  {
    const Vector3 inCube = this->InCube({place[0], place[1], place[2]});
    if (place[3] == 0)
    {
      return InMiddle(inCube);
    }
    const double part = static_cast<double>(place[3]) / this->Layers;
    return (1.0 - part) * InMiddle(inCube) + part * EquiangularPoint(inCube).normalized();
  }

  std::vector<StarMesh::Element> Elements() const
  {
    std::vector<StarMesh::Element> elements;
    for (int k = 0; k < this->Across; ++k)
    {
      for (int j = 0; j < this->Across; ++j)
      {
        for (int i = 0; i < this->Across; ++i)
        {
          elements.push_back({this->Node({i, j, k}), this->Node({i + 1, j, k}),
                              this->Node({i + 1, j + 1, k}), this->Node({i, j + 1, k}),
                              this->Node({i, j, k + 1}), this->Node({i + 1, j, k + 1}),
                              this->Node({i + 1, j + 1, k + 1}), this->Node({i, j + 1, k + 1})});
        }
      }
    }
    for (const std::array<Lattice, 4>& side : this->Sides())
    {
      for (int layer = 0; layer < this->Layers; ++layer)
      {
        StarMesh::Element element{};
        for (std::size_t corner = 0; corner < 4; ++corner)
        {
          element[corner] = this->Node(side[corner], layer);
          element[corner + 4] = this->Node(side[corner], layer + 1);
        }
        elements.push_back(element);
      }
    }
    return elements;
  }

  std::vector<StarMesh::Face> Faces() const
  {
    std::vector<StarMesh::Face> faces;
    for (const std::array<Lattice, 4>& side : this->Sides())
    {
      StarMesh::Face face{};
      for (std::size_t corner = 0; corner < 4; ++corner)
      {
        face.Nodes[corner] = this->Node(side[corner], this->Layers);
        face.OnCube[corner] = this->InCube(side[corner]);
      }
      faces.push_back(face);
    }
    return faces;
  }

private:
  Vector3 InCube(const Lattice& place) const noexcept
  {
    return Vector3(place[0], place[1], place[2]) * (2.0 / this->Across) - Vector3::Ones();
  }
  std::size_t IndexInCube(const Lattice& place) const noexcept
  {
    const auto size = static_cast<std::size_t>(this->Across + 1);
    return static_cast<std::size_t>(place[0]) +
           size * (static_cast<std::size_t>(place[1]) + size * static_cast<std::size_t>(place[2]));
  }
  int Node(const Lattice& place, int layer = 0) const noexcept
  {
    const std::size_t inCube = this->IndexInCube(place);
    const auto cube = static_cast<int>(this->OuterIndex.size());
    return layer == 0 ? static_cast<int>(inCube)
                      : cube + (layer - 1) * static_cast<int>(this->Outer.size()) +
                            this->OuterIndex[inCube];
  }
  void Number()
  {
    const auto size = static_cast<std::size_t>(this->Across + 1);
    this->OuterIndex.assign(size * size * size, -1);
    for (int k = 0; k <= this->Across; ++k)
    {
      for (int j = 0; j <= this->Across; ++j)
      {
        for (int i = 0; i <= this->Across; ++i)
        {
          const Lattice place{i, j, k};
          if (std::any_of(place.begin(), place.end(),
                          [this](int c) { return c == 0 || c == this->Across; }))
          {
            this->OuterIndex[this->IndexInCube(place)] = static_cast<int>(this->Outer.size());
            this->Outer.push_back(place);
          }
        }
      }
    }
  }
  // Squares of the cube's surface, counterclockwise from outside.
  std::vector<std::array<Lattice, 4>> Sides() const
  {
    std::vector<std::array<Lattice, 4>> sides;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int end : {0, this->Across})
      {
        for (int u = 0; u < this->Across; ++u)
        {
          for (int v = 0; v < this->Across; ++v)
          {
            const auto at = [&](int du, int dv)
            {
              Lattice place{};
              place[axis] = end;
              place[(axis + 1) % 3] = u + du;
              place[(axis + 2) % 3] = v + dv;
              return place;
            };
            sides.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
            if (end == 0)
            {
              std::swap(sides.back()[1], sides.back()[3]);
            }
          }
        }
      }
    }
    return sides;
  }

  int Across;
  int Layers;
  std::vector<Lattice> Outer;  // lattice points on the cube's surface
  std::vector<int> OuterIndex; // of each lattice point, or -1
};

bool IsValid(const std::vector<Vector3>& nodes, const std::vector<StarMesh::Element>& elements)
{
  return std::all_of(elements.begin(), elements.end(),
                     [&](const StarMesh::Element& element)
                     {
                       HexahedronShape shape(nodes, element);
                       return shape.IsValid();
                     });
}
} // namespace

Status StarMesh::Make(const RadialModel& model, int elementsAcross, StarMesh& mesh)
{
  if (elementsAcross < FewestElements || elementsAcross > MostElements || elementsAcross % 2 != 0)
  {
    return Status::Failure("The number of elements across is not an even number from " +
                           std::to_string(FewestElements) + " to " + std::to_string(MostElements) +
                           ".");
  }
  const CubedBall ball(elementsAcross);
  mesh.NodePlaces = ball.Places();
  mesh.NodePoints.clear();
  for (const Place& place : mesh.NodePlaces)
  {
    mesh.NodePoints.push_back(ball.Point(place));
  }
  std::vector<double> radii(mesh.NodePoints.size());
  double least = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const double length = mesh.NodePoints[i].norm();
    radii[i] = model.Radius(length > 0.0 ? Vector3(mesh.NodePoints[i] / length) : Vector3::UnitZ());
    least = std::min(least, radii[i]);
    sum += radii[i];
  }
  if (!(least > 0.0) || !std::isfinite(sum))
  {
    return Status::Failure("The model's radius is not positive in all directions.");
  }
  constexpr double Most = 1.8; // of the least radius; 2 would be singular
  const double middle = std::min(sum / static_cast<double>(radii.size()), Most * least);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    Vector3& point = mesh.NodePoints[i];
    point *= middle + (radii[i] - middle) * point.norm();
  }
  mesh.Hexahedra = ball.Elements();
  mesh.SurfaceFaces = ball.Faces();
  return IsValid(mesh.NodePoints, mesh.Hexahedra)
             ? Status::Success()
             : Status::Failure("The surface is too rough for elements of this size; more elements "
                               "or a lower degree may help.");
}

double StarMesh::SurfaceEdge() const noexcept
{
  double sum = 0.0;
  for (const Face& face : this->SurfaceFaces)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      sum += (this->NodePoints[static_cast<std::size_t>(face.Nodes[i])] -
              this->NodePoints[static_cast<std::size_t>(face.Nodes[(i + 1) % 4])])
                 .norm();
    }
  }
  return sum / (4.0 * static_cast<double>(this->SurfaceFaces.size()));
}

StarMesh::FacePoint StarMesh::At(const Face& face, double s, double t) noexcept
{
  FacePoint point{};
  point.Shape = {0.25 * (1.0 - s) * (1.0 - t), 0.25 * (1.0 + s) * (1.0 - t),
                 0.25 * (1.0 + s) * (1.0 + t), 0.25 * (1.0 - s) * (1.0 + t)};
  const std::array<Vector3, 4>& q = face.OnCube;
  const Vector3 onCube =
      point.Shape[0] * q[0] + point.Shape[1] * q[1] + point.Shape[2] * q[2] + point.Shape[3] * q[3];
  const Vector3 alongS = 0.25 * ((1.0 - t) * (q[1] - q[0]) + (1.0 + t) * (q[2] - q[3]));
  const Vector3 alongT = 0.25 * ((1.0 - s) * (q[3] - q[0]) + (1.0 + s) * (q[2] - q[1]));
  const Vector3 e = EquiangularPoint(onCube);
  // d tan(x) = (1 + tan^2 x) dx
  const Vector3 slope = QuarterTurn * (e.array().square() + 1.0);
  const double length = e.norm();
  point.Direction = e / length;
  point.SolidAngle = std::abs(e.dot(slope.cwiseProduct(alongS).cross(slope.cwiseProduct(alongT)))) /
                     (length * length * length);
  return point;
}
} // namespace palpate
