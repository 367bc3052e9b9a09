#pragma once

#include "ContactCases.h"
#include "FieldCases.h"
#include "FieldContactModel.h"
#include "ProceduralFields.h"
#include "PublishedShell.h"

namespace palpate::test
{
inline std::shared_ptr<const ContactModel>
FieldContact(const std::shared_ptr<const ScalarField>& field)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = FieldContactModel::Make(field, 0, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

/// The same by the published method.
inline std::shared_ptr<const ContactModel>
PublishedContact(const std::shared_ptr<const ScalarField>& field)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = MakePublishedShell(field, 0, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

/// Voxels of 0.5 mm, off the origin.
inline FieldGrid FineGrid(int size)
{
  return {{size, size, size}, {-12.5, 40.25, 7.0}, Vector3::Constant(0.5), Matrix3::Identity()};
}

/// Samples a procedural field (in index coordinates) on the grid; inside where >= 0.
template <typename Procedure>
std::shared_ptr<const ScalarField>
SampledField(const FieldGrid& grid, const Procedure& procedure,
             FieldInterpolation interpolation = FieldInterpolation::Trilinear)
{
  return MakeField(grid, SampleAtIndices<float>(grid.Size(), procedure), 0.0, interpolation);
}

/// The distance (mm) from a point to the field's surface, positive outside, by value over gradient:
/// accurate near the surface.
inline double FieldDistance(const FieldSampler& sampler, const Vector3& pointWorld)
{
  const FieldGradientSample sample = sampler.ValueAndGradientWorld(0, pointWorld);
  return -sample.Value / sample.Gradient.norm();
}
} // namespace palpate::test
