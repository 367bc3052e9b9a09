#pragma once

#include "CellVolume.h"
#include "DrilledField.h"
#include "FieldCases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <vector>

namespace palpate::test
{
/// Simulated scan of bone: 1500 inside a sphere and 0 outside, blurred at the edge, iso-value 300,
/// in an oblique grid. A label, a second channel, limits another material: a nerve within the bone.
class ScannedBone
{
public:
  static constexpr double Iso = 300.0;
  static constexpr double Inside = 1500.0;

  ScannedBone(const FieldGrid& grid, double radius, double blur)
      : Grid(grid), Center(grid.PointWorld(
                        0.5 * Vector3(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1)))
  {
    for (std::size_t n = 0; n < grid.NodeCount(); ++n)
    {
      const Vector3 p = grid.PointWorld(NodeIndex(grid.Size(), n));
      const double depth = radius - (p - this->Center).norm();
      this->Bone.push_back(
          static_cast<float>(std::round(0.5 * Inside * (1.0 + std::tanh(depth / blur)))));
      // Around an axis of the world off the centre.
      const Vector3 nearby = p - this->Center - Vector3(0.3 * radius, 0.0, 0.0);
      this->Nerve.push_back(static_cast<float>(0.12 * radius - std::hypot(nearby[0], nearby[1])));
    }
  }

  std::shared_ptr<const ScalarField> Make(const std::vector<float>& bone,
                                          bool keepsAll = false) const
  {
    FieldBuilder builder(this->Grid);
    const int first = builder.AddChannel(SamplesOfGrid(bone.data(), this->Grid));
    const int second = builder.AddChannel(SamplesOfGrid(this->Nerve.data(), this->Grid));
    builder.KeepInside(builder.AddMaterial({first, Iso}));
    builder.AddMaterial({second, 0.0});
    if (keepsAll)
    {
      builder.KeepAll();
    }
    std::shared_ptr<const ScalarField> field;
    const Status status = builder.Build(field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return field;
  }
  std::shared_ptr<const ScalarField> Make() const { return this->Make(this->Bone); }

  FieldGrid Grid;
  Vector3 Center;
  std::vector<float> Bone;
  std::vector<float> Nerve;
};

inline std::unique_ptr<DrilledField> Drill(const ScalarField& field, int material = 0)
{
  std::unique_ptr<DrilledField> drilled;
  const Status status = DrilledField::Make(field, material, drilled);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return drilled;
}

inline std::shared_ptr<const ScalarField> VersionOf(DrilledField& drilled)
{
  std::shared_ptr<const ScalarField> version;
  const Status status = drilled.MakeVersion(version);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return version;
}

inline void CutPath(DrilledField& drilled, const CutTool& tool, const Vector3& from,
                    const Vector3& to)
{
  const auto still = Eigen::Quaterniond::Identity();
  const Status status = drilled.Cut(tool, {from, still}, {to, still});
  EXPECT_TRUE(status.IsOk()) << status.Message();
}

inline std::vector<float> SamplesNow(const DrilledField& drilled, const ScannedBone& bone)
{
  std::vector<float> samples(bone.Bone.size());
  drilled.WriteSamples(SamplesOfGrid(bone.Bone.data(), bone.Grid), samples.data());
  return samples;
}
} // namespace palpate::test
