#pragma once

#include "FieldBuilder.h"
#include "ServoRun.h"
#include "StructureFollower.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

namespace palpate::test
{
/// A grid of voxels of 1 mm around the origin, turned by `turn`.
inline FieldGrid FeltGrid(int size, const Matrix3& turn = Matrix3::Identity())
{
  const Vector3 middle = Vector3::Constant(0.5 * (size - 1));
  return {{size, size, size}, -(turn * middle), Vector3::Ones(), turn};
}

/// An image of a function of the place in the world, mm.
inline std::shared_ptr<const ScalarField>
FeltField(const FieldGrid& grid, const std::function<double(const Vector3&)>& value,
          FieldInterpolation interpolation = FieldInterpolation::Trilinear)
{
  std::vector<double> samples;
  for (int k = 0; k < grid.Size()[2]; ++k)
  {
    for (int j = 0; j < grid.Size()[1]; ++j)
    {
      for (int i = 0; i < grid.Size()[0]; ++i)
      {
        samples.push_back(value(grid.PointWorld(Vector3(i, j, k))));
      }
    }
  }
  FieldBuilder builder(grid);
  builder.KeepAll();
  builder.SetInterpolation(interpolation);
  builder.AddChannel(SamplesOfGrid(samples.data(), grid));
  std::shared_ptr<const ScalarField> field;
  const Status status = builder.Build(field);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return field;
}

/// N mm that the first structure of a scene gives to a hand on a closed path, a function of a turn
/// from 0 to 1 (mm, device's frame), without the safety chain. The midpoint rule: its error is
/// proportional to the squared step. Starts with half a turn at zero force, so that it does not
/// depend on the start.
class ClosedPath
{
public:
  struct Work
  {
    double All = 0.0;
    double Push = 0.0; ///< of the force along the normal
  };

  explicit ClosedPath(const TouchScene& scene) : Scene(scene)
  {
    const Status status =
        StructureFollower::Make(this->Scene.Structures.front(), this->Scene, 0.01, this->Followers);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  Work Along(const std::function<Vector3(double)>& path, int steps)
  {
    Work work;
    this->At(path(0.0));
    for (int n = 0; n < steps; ++n)
    {
      const Vector3 from = path(1.0 * n / steps);
      const Vector3 to = path((n + 1.0) / steps);
      const Vector3 force = this->At(0.5 * (from + to));
      const Vector3 normal =
          this->Scene.Frame.TurnedToDevice(this->Followers.front().Touched().NormalWorld);
      work.All += force.dot(to - from);
      work.Push += force.dot(normal) * normal.dot(to - from);
    }
    return work;
  }
  /// N mm of the force fields alone; `largest` becomes the largest force (N).
  double FieldAlong(const std::function<Vector3(double)>& path, int steps, double& largest)
  {
    double work = 0.0;
    this->At(path(0.0));
    for (int n = 0; n < steps; ++n)
    {
      const Vector3 from = path(1.0 * n / steps);
      const Vector3 to = path((n + 1.0) / steps);
      this->At(0.5 * (from + to));
      const Vector3& force = this->Followers.front().FieldForce();
      work += force.dot(to - from);
      largest = std::max(largest, force.norm());
    }
    return work;
  }
  /// N, in the device's frame, of the contact.
  Vector3 At(const Vector3& hand)
  {
    DeviceSample sample;
    sample.Position = hand;
    FollowStep step;
    step.Hand = hand;
    step.Now = this->Scene.Frame.PoseWorld(sample);
    step.Last = this->HasLast ? this->Last : step.Now;
    step.Passed = 1e-3;
    this->Last = step.Now;
    this->HasLast = true;
    return this->Followers.front().Follow(step);
  }

private:
  TouchScene Scene;
  std::vector<StructureFollower> Followers;
  ToolPose Last;
  bool HasLast = false;
};
} // namespace palpate::test
