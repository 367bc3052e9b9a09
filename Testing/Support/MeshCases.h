#pragma once

#include "ContactCases.h"
#include "FacetContactModel.h"
#include "IcosahedronDirections.h"

#include <vector>

namespace palpate::test
{
/// Points and triangles of a closed mesh.
struct Mesh
{
  std::vector<Vector3> Points;
  std::vector<FacetTree::Triangle> Triangles;

  Facet FacetAt(std::size_t number) const
  {
    const FacetTree::Triangle& t = this->Triangles[number];
    const auto corner = [&](std::size_t n) { return this->Points[static_cast<std::size_t>(t[n])]; };
    return {corner(0), corner(1), corner(2)};
  }
};

/// With one vertex for each direction of an icosahedron.
inline Mesh MeshOf(const RadialModel& model, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  Mesh mesh;
  for (const Vector3& u : sphere.Directions())
  {
    mesh.Points.push_back(model.PointWorld(u));
  }
  mesh.Triangles = sphere.Triangles();
  return mesh;
}

/// Two triangles a side, around the origin.
inline Mesh BoxMesh(const Vector3& halfSize)
{
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    mesh.Points.push_back(sign.cwiseProduct(halfSize));
  }
  mesh.Triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline std::shared_ptr<const ContactModel> FacetContact(const Mesh& mesh)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = FacetContactModel::Make(mesh.Points, mesh.Triangles, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

inline std::shared_ptr<const FacetTree> TreeOf(const Mesh& mesh)
{
  std::shared_ptr<const FacetTree> tree;
  const Status status = FacetTree::Make(mesh.Points, mesh.Triangles, tree);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return tree;
}
} // namespace palpate::test
