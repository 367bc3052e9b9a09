#pragma once

#include "FieldContactCases.h"
#include "MeshCases.h"
#include "SharedProxy.h"

#include <memory>
#include <vector>

namespace palpate::test
{
constexpr double TouchedRadius = 15.0; ///< mm, of the structures

/// A tool among some models, all of which are near.
class SharedTool
{
public:
  explicit SharedTool(const ToolShape& shape)
      : Shape(shape), Proxy(*shape.Skeleton(), shape.Skeleton()->Gyration())
  {
  }

  void Among(const ContactModel& model, const SurfaceFriction& friction = {})
  {
    std::unique_ptr<ToolGaps> gaps;
    const Status status = model.MakeGaps(this->Shape, friction, gaps);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    this->Near.push_back(static_cast<std::uint32_t>(this->Proxy.Add(std::move(gaps))));
  }
  void Begin(const ToolPose& pose)
  {
    this->Proxy.Begin(pose, this->Near.data(), this->Near.size());
  }
  void Follow(const ToolPose& hand)
  {
    this->Proxy.Follow(hand, this->Near.data(), this->Near.size());
  }
  // Until the proxy rests.
  const Contact& Settle(const ToolPose& hand, std::size_t structure = 0)
  {
    for (int tick = 0; tick < 400; ++tick)
    {
      this->Follow(hand);
      if (!this->Proxy.ShareOf(structure).IsBehind)
      {
        break;
      }
    }
    return this->Proxy.ShareOf(structure);
  }
  const Vector3& CutOffset(std::size_t structure) const { return this->Proxy.CutOffset(structure); }
  const ToolPose& Place() const { return this->Proxy.Pose(); }
  const Contact& ShareOf(std::size_t structure) const { return this->Proxy.ShareOf(structure); }
  bool Passes(std::size_t structure) const { return this->Proxy.Passes(structure); }

private:
  ToolShape Shape;
  SharedProxy Proxy;
  std::vector<std::uint32_t> Near;
};

/// A ball of 15 mm in voxels of 0.5 mm; index coordinates.
struct BallField
{
  Vector3 Middle;

  double Value(const Vector3& p) const { return 2.0 * TouchedRadius - (p - this->Middle).norm(); }
};

inline std::shared_ptr<const ContactModel> BallByField(const Vector3& center)
{
  const FieldGrid grid = FineGrid(96);
  return FieldContact(SampledField(grid, BallField{grid.PointIndex(center)}));
}

struct TouchedBall
{
  const char* Name;
  std::shared_ptr<const ContactModel> Model;
  Vector3 Center;
  double Error; // mm
};

/// The ball as all kinds of structures. The mesh is inside of it by up to 0.01 mm; the gradient of
/// an interpolated distance turns by as much within a voxel.
inline std::vector<TouchedBall> TouchedBalls()
{
  const RadialModel ball = Sphere(TouchedRadius, Vector3(3.0, -2.0, 5.0));
  const Vector3 inField = FineGrid(96).PointWorld(Vector3::Constant(47.3));
  return {{"radial", RadialContact(ball), ball.CenterWorld(), 1e-6},
          {"facets", FacetContact(MeshOf(ball, 40)), ball.CenterWorld(), 0.01},
          {"field", BallByField(inField), inField, 0.015}};
}

} // namespace palpate::test
