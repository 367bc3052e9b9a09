#include "ConvexHull.h"

#include "ExactSign.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
struct HullFace
{
  std::array<int, 3> Corners;
  std::array<int, 3> Across{-1, -1, -1}; // the faces at the edges from each corner to the next
  std::vector<int> Outside;              // points that this face sees, each in one face's list
  bool IsGone = false;
};

// An edge between a face that the new point sees, and one that it does not see.
struct HorizonEdge
{
  int From;
  int To;
  int Beyond; // the face that stays
};

class HullBuilder
{
public:
  explicit HullBuilder(const std::vector<Vector3>& points) : Points(points) {}

  IndexedMesh Build()
  {
    if (!this->BeginWithTetrahedron())
    {
      return {};
    }
    for (std::size_t face = 0; face < this->Faces.size(); ++face)
    {
      if (!this->Faces[face].IsGone && !this->Faces[face].Outside.empty())
      {
        this->AddPoint(static_cast<int>(face), this->FarthestOf(this->Faces[face]));
      }
    }
    IndexedMesh hull;
    hull.Points = this->Points;
    for (const HullFace& face : this->Faces)
    {
      if (!face.IsGone)
      {
        hull.Triangles.push_back(face.Corners);
      }
    }
    return hull;
  }

private:
  const Vector3& At(int point) const { return this->Points[static_cast<std::size_t>(point)]; }
  HullFace& Face(int face) { return this->Faces[static_cast<std::size_t>(face)]; }
  bool Sees(int point, const HullFace& face) const
  {
    const auto [a, b, c] = face.Corners;
    return exact::VolumeSign(this->At(a), this->At(b), this->At(c), this->At(point)) > 0;
  }

  // The point where a function is largest.
  template <typename Function>
  int Largest(const Function& function) const
  {
    std::size_t best = 0;
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      best = function(this->Points[i]) > function(this->Points[best]) ? i : best;
    }
    return static_cast<int>(best);
  }

  bool BeginWithTetrahedron()
  {
    if (this->Points.size() < 4)
    {
      return false;
    }
    std::array<int, 4> p{};
    p[0] = this->Largest([](const Vector3& x) { return -x[0]; });
    p[1] = this->Largest([&](const Vector3& x) { return (x - this->At(p[0])).squaredNorm(); });
    const Vector3 along = this->At(p[1]) - this->At(p[0]);
    p[2] = this->Largest([&](const Vector3& x) { return along.cross(x - this->At(p[0])).norm(); });
    const Vector3 normal = along.cross(this->At(p[2]) - this->At(p[0]));
    p[3] =
        this->Largest([&](const Vector3& x) { return std::abs(normal.dot(x - this->At(p[0]))); });
    const int sign =
        exact::VolumeSign(this->At(p[0]), this->At(p[1]), this->At(p[2]), this->At(p[3]));
    if (sign == 0)
    {
      return false;
    }
    if (sign > 0) // the fourth point has to lie behind the first face
    {
      std::swap(p[0], p[1]);
    }
    this->Faces = {{{p[0], p[1], p[2]}, {1, 2, 3}, {}, false},
                   {{p[1], p[0], p[3]}, {0, 3, 2}, {}, false},
                   {{p[2], p[1], p[3]}, {0, 1, 3}, {}, false},
                   {{p[0], p[2], p[3]}, {0, 2, 1}, {}, false}};
    std::vector<int> all(this->Points.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      all[i] = static_cast<int>(i);
    }
    this->Distribute(all, 0);
    return true;
  }

  // Gives each point to the first face, from one on, that sees it; points that none sees are
  // inside.
  void Distribute(const std::vector<int>& points, std::size_t from)
  {
    for (const int point : points)
    {
      const auto face =
          std::find_if(this->Faces.begin() + static_cast<std::ptrdiff_t>(from), this->Faces.end(),
                       [&](const HullFace& one) { return this->Sees(point, one); });
      if (face != this->Faces.end())
      {
        face->Outside.push_back(point);
      }
    }
  }

  int FarthestOf(const HullFace& face) const
  {
    const auto [a, b, c] = face.Corners;
    const Vector3 normal = (this->At(b) - this->At(a)).cross(this->At(c) - this->At(a));
    return *std::max_element(face.Outside.begin(), face.Outside.end(),
                             [&](int one, int other)
                             { return normal.dot(this->At(one)) < normal.dot(this->At(other)); });
  }

  // Replaces the faces that a point sees by a fan from their rim to it.
  void AddPoint(int start, int point)
  {
    std::vector<HorizonEdge> horizon;
    std::vector<int> freed;
    std::vector<int> seen{start};
    this->Face(start).IsGone = true;
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
      const HullFace face = std::move(this->Face(seen[i]));
      this->Face(seen[i]) = {face.Corners, face.Across, {}, true};
      freed.insert(freed.end(), face.Outside.begin(), face.Outside.end());
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const int across = face.Across[edge];
        if (this->Face(across).IsGone)
        {
          continue;
        }
        if (this->Sees(point, this->Face(across)))
        {
          this->Face(across).IsGone = true;
          seen.push_back(across);
        }
        else
        {
          horizon.push_back({face.Corners[edge], face.Corners[(edge + 1) % 3], across});
        }
      }
    }
    const std::size_t first = this->Faces.size();
    this->AddFan(horizon, point);
    this->Distribute(freed, first);
  }

  void AddFan(const std::vector<HorizonEdge>& horizon, int point)
  {
    const auto first = static_cast<int>(this->Faces.size());
    const auto faceFrom = [&](int corner)
    {
      const auto edge = std::find_if(horizon.begin(), horizon.end(),
                                     [&](const HorizonEdge& one) { return one.From == corner; });
      return first + static_cast<int>(edge - horizon.begin());
    };
    const auto faceTo = [&](int corner)
    {
      const auto edge = std::find_if(horizon.begin(), horizon.end(),
                                     [&](const HorizonEdge& one) { return one.To == corner; });
      return first + static_cast<int>(edge - horizon.begin());
    };
    for (const HorizonEdge& edge : horizon)
    {
      const auto made = static_cast<int>(this->Faces.size());
      HullFace& beyond = this->Face(edge.Beyond);
      const auto place = std::find(beyond.Corners.begin(), beyond.Corners.end(), edge.To);
      beyond.Across[static_cast<std::size_t>(place - beyond.Corners.begin())] = made;
      this->Faces.push_back({{edge.From, edge.To, point},
                             {edge.Beyond, faceFrom(edge.To), faceTo(edge.From)},
                             {},
                             false});
    }
  }

  const std::vector<Vector3>& Points;
  std::vector<HullFace> Faces;
};
} // namespace

IndexedMesh ConvexHullOf(const std::vector<Vector3>& points)
{
  return HullBuilder(points).Build();
}
} // namespace palpate
