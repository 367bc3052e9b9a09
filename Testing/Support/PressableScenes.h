#pragma once

#include "FacetContactModel.h"
#include "FieldBuilder.h"
#include "FieldContactModel.h"
#include "IcosahedronDirections.h"
#include "OrganContact.h"
#include "ProceduralFields.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "TouchDoubles.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate::test
{
/// One structure that a tool begins to touch at the origin of the device's frame, which has a
/// random orientation relative to it.
struct PressableScene
{
  std::string Kind;
  TouchScene Scene;
  Vector3 Outward; ///< unit vector out of the structure there, device's frame
};

namespace pressable
{
constexpr double ToolRadius = 2.0; // mm
constexpr double VoxelSize = 0.5;  // mm

inline PressableScene At(Random& random, const char* kind, const ToolShape& tool,
                         std::shared_ptr<const ContactModel> model, const Vector3& centerWorld,
                         const Vector3& normalWorld)
{
  const Matrix3 rotation = RandomOrientation(random);
  PressableScene made{kind, {}, rotation.transpose() * normalWorld};
  made.Scene.Tool = tool;
  made.Scene.Frame = DeviceFrame(rotation, 1.0, centerWorld);
  made.Scene.Structures.push_back({kind, std::move(model), {}, {}});
  return made;
}

// A sphere of voxels.
inline std::shared_ptr<const ContactModel> Voxels(const Vector3& centerIndex, double radius,
                                                  double spacing)
{
  constexpr int Nodes = 90;
  const FieldGrid grid({Nodes, Nodes, Nodes}, Vector3::Zero(), Vector3::Constant(spacing),
                       Matrix3::Identity());
  const SphereField sphere{centerIndex, radius / spacing};
  const std::vector<float> samples = SampleAtIndices<float>(grid.Size(), sphere);
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
  std::shared_ptr<const ScalarField> field;
  std::shared_ptr<const ContactModel> model;
  const bool isMade =
      builder.Build(field).IsOk() && FieldContactModel::Make(field, 0, model).IsOk();
  return isMade ? model : nullptr;
}
} // namespace pressable

/// A wall, an organ by its harmonics' closest point and as facets, and a sphere as voxels, touched
/// by a point and by a sphere of 26 points. If a structure cannot be made its model is null, which
/// a servo refuses.
inline std::vector<PressableScene> MakePressableScenes(Random& random)
{
  using namespace pressable;
  const auto organ = std::make_shared<const RadialModel>(RandomOrgan(random, 12));
  const Vector3 place = RandomDirection(random);
  const Vector3 normal = organ->Normal(place);
  const Vector3 center = organ->PointWorld(place) + ToolRadius * normal;
  std::shared_ptr<const ContactModel> harmonics;
  const bool isHarmonics = MakeOrganContact(organ, RadialContactMode::Nearest, harmonics).IsOk();
  const IcosahedronDirections sphere(20);
  std::vector<Vector3> corners;
  for (const Vector3& u : sphere.Directions())
  {
    corners.push_back(organ->PointWorld(u));
  }
  std::shared_ptr<const ContactModel> facets;
  const bool isFacets = FacetContactModel::Make(corners, sphere.Triangles(), facets).IsOk();

  constexpr double SphereRadius = 20.0; // mm
  const Vector3 sphereIndex(44.3, 45.1, 43.7);
  const auto voxels = Voxels(sphereIndex, SphereRadius, pressable::VoxelSize);
  const Vector3 centerWorld = pressable::VoxelSize * sphereIndex;

  const ToolShape point = ToolShape::Sphere(0.0);
  const ToolShape tool = ToolShape::Sphere(ToolRadius);
  const ToolShape shell = ToolShape::SpherePoints(ToolRadius, ToolShape::NeighbourCount);
  return {At(random, "wall", point, std::make_shared<WallModel>(0.0), Vector3::Zero(),
             Vector3::UnitZ()),
          At(random, "harmonics", tool, isHarmonics ? harmonics : nullptr, center, normal),
          At(random, "facets", tool, isFacets ? facets : nullptr, center, normal),
          At(random, "sub-voxel, point", point, voxels, centerWorld + SphereRadius * place, place),
          At(random, "sub-voxel, 26 points", shell, voxels,
             centerWorld + (SphereRadius + ToolRadius) * place, place)};
}
} // namespace palpate::test
