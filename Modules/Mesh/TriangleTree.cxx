#include "TriangleTree.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double FarthestCorner = 1e30; // fits into float, and its cube into double
// Of a node's triangles, on either side; bounds the depth: ln(MostTriangles) / -ln(1 - share) = 57.
constexpr double SmallerPart = 0.3;
constexpr std::size_t MostTriangles = 700'000'000;

// A unit or two in the last place too low, which takes no branch.
float Below(double x)
{
  const auto rounded = static_cast<float>(x);
  return rounded - (std::abs(rounded) * std::numeric_limits<float>::epsilon() +
                    std::numeric_limits<float>::min());
}

float Above(double x)
{
  return -Below(-x);
}

FloatBox BoxOf(const IndexedMesh& mesh, const std::array<int, 3>& t)
{
  const Vector3& a = mesh.Points[t[0]];
  const Vector3& b = mesh.Points[t[1]];
  const Vector3& c = mesh.Points[t[2]];
  const Vector3 low = a.cwiseMin(b).cwiseMin(c);
  const Vector3 high = a.cwiseMax(b).cwiseMax(c);
  return {{Below(low[0]), Below(low[1]), Below(low[2])},
          {Above(high[0]), Above(high[1]), Above(high[2])}};
}

Status CheckMesh(const IndexedMesh& mesh)
{
  if (mesh.Triangles.empty() || mesh.Triangles.size() > MostTriangles)
  {
    return Status::Failure(mesh.Triangles.empty()
                               ? "The mesh has no triangles."
                               : "The mesh has more than 700 million triangles.");
  }
  if (!std::all_of(mesh.Points.begin(), mesh.Points.end(),
                   [](const Vector3& p)
                   { return p.cwiseAbs().maxCoeff() <= FarthestCorner && p.allFinite(); }))
  {
    return Status::Failure("The mesh has coordinates that are not finite or beyond 1e30 mm.");
  }
  const auto isValid = [&mesh](int p)
  { return p >= 0 && static_cast<std::size_t>(p) < mesh.Points.size(); };
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(),
                     [&](const std::array<int, 3>& t)
                     { return std::all_of(t.begin(), t.end(), isValid); })
             ? Status::Success()
             : Status::Failure("The mesh has triangles with invalid point indices.");
}
} // namespace

Status TriangleTree::Make(const IndexedMesh& mesh, TriangleTree& tree, TriangleBoxes boxes)
{
  if (Status status = CheckMesh(mesh); !status.IsOk())
  {
    return status;
  }
  const std::size_t count = mesh.Triangles.size();
  std::vector<Center> centers(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    const FloatBox box = BoxOf(mesh, mesh.Triangles[t]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      centers[t].At[axis] = 0.5F * (box.Low[axis] + box.High[axis]);
    }
    centers[t].Triangle = static_cast<std::int32_t>(t);
  }
  tree.Tree.clear();
  tree.Tree.reserve(count + 1); // at least 2 triangles a leaf
  tree.Numbers.resize(count);
  tree.Build(centers, 0, count);
  std::transform(centers.begin(), centers.end(), tree.Numbers.begin(),
                 [](const Center& center) { return center.Triangle; });
  const auto boxAt = [&](std::size_t place)
  { return BoxOf(mesh, mesh.Triangles[tree.Numbers[place]]); };
  for (std::size_t n = tree.Tree.size(); n-- > 0;) // children follow their parents
  {
    Node& node = tree.Tree[n];
    node.Box = node.Count > 0 ? boxAt(node.Second) : tree.Tree[n + 1].Box;
    for (int i = 1; i < node.Count; ++i)
    {
      node.Box.Extend(boxAt(node.Second + i));
    }
    if (node.Count == 0)
    {
      node.Box.Extend(tree.Tree[node.Second].Box);
    }
  }
  tree.BoxOfPlace.clear();
  for (std::size_t place = 0; boxes == TriangleBoxes::Kept && place < count; ++place)
  {
    tree.BoxOfPlace.push_back(boxAt(place));
  }
  return Status::Success();
}

void TriangleTree::Build(std::vector<Center>& centers, std::size_t begin, std::size_t end)
{
  const std::size_t number = this->Tree.size();
  this->Tree.push_back({});
  if (end - begin <= LeafSize)
  {
    this->Tree[number].Second = static_cast<std::int32_t>(begin);
    this->Tree[number].Count = static_cast<std::int32_t>(end - begin);
    return;
  }
  const std::size_t middle = Split(centers, begin, end);
  this->Build(centers, begin, middle);
  this->Tree[number].Second = static_cast<std::int32_t>(this->Tree.size());
  this->Build(centers, middle, end);
}

std::size_t TriangleTree::Split(std::vector<Center>& centers, std::size_t begin, std::size_t end)
{
  FloatBox spread{centers[begin].At, centers[begin].At};
  for (std::size_t i = begin + 1; i < end; ++i)
  {
    spread.Extend({centers[i].At, centers[i].At});
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    longest = spread.High[axis] - spread.Low[axis] > spread.High[longest] - spread.Low[longest]
                  ? axis
                  : longest;
  }
  const auto at = [&centers](std::size_t i)
  { return centers.begin() + static_cast<std::ptrdiff_t>(i); };
  const float halfway = 0.5F * spread.Low[longest] + 0.5F * spread.High[longest];
  const auto cut = std::partition(at(begin), at(end),
                                  [longest, halfway](const Center& center)
                                  { return center.At[longest] < halfway; });
  const std::size_t count = end - begin;
  const auto below = static_cast<std::size_t>(cut - at(begin));
  if (std::min(below, count - below) >= SmallerPart * count)
  {
    return begin + below;
  }
  const std::size_t middle = begin + count / 2;
  // The number decides between equal centres, so that every library finds the same halves.
  std::nth_element(at(begin), at(middle), at(end),
                   [longest](const Center& one, const Center& other)
                   {
                     return one.At[longest] != other.At[longest]
                                ? one.At[longest] < other.At[longest]
                                : one.Triangle < other.Triangle;
                   });
  return middle;
}
} // namespace palpate
