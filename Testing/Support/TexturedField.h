#pragma once

#include "FieldBuilder.h"
#include "ProceduralFields.h"

#include <memory>

namespace palpate::test
{
/// An image with alternating bright and dark regions, with samples everywhere: a gyroid with a
/// period of 6 mm on nodes of 1 mm, 31 mm wide around the origin. Null if it cannot be made.
inline std::shared_ptr<const ScalarField> TexturedField()
{
  constexpr int Nodes = 32;
  const FieldGrid grid({Nodes, Nodes, Nodes}, Vector3::Constant(-15.5), Vector3::Ones(),
                       Matrix3::Identity());
  const auto samples = SampleAtIndices<float>(grid.Size(), GyroidField{6.0});
  FieldBuilder builder(grid);
  builder.KeepAll();
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
  std::shared_ptr<const ScalarField> field;
  return builder.Build(field).IsOk() ? field : nullptr;
}

/// The box of such an image.
inline Eigen::AlignedBox3d TexturedBox()
{
  return {Vector3::Constant(-12.0), Vector3::Constant(12.0)};
}
} // namespace palpate::test
