#include "FieldSampler.h"

#include "CellPlace.h"
#include "TricubicCell.h"
#include "TrilinearCell.h"

namespace palpate
{
namespace
{
template <typename Cell>
Cell LoadCell(const BrickedChannel& channel, std::uint32_t block, const CellPlace& place) noexcept
{
  Cell cell;
  cell.Load(channel, block, place.FirstNode);
  return cell;
}

template <typename Cell>
FieldSample ValueOf(const ScalarField& field, int channel, const Vector3& pointIndex) noexcept
{
  CellPlace place;
  if (!place.Locate(field.Layout(), pointIndex))
  {
    return {};
  }
  const BrickedChannel& samples = field.Channel(channel);
  const BrickedChannel::Slot slot = samples.SlotOf(place.Brick);
  if (slot.Block == BrickedChannel::NotStored)
  {
    return {SampleKind::Constant, slot.Constant};
  }
  return {SampleKind::Sampled, LoadCell<Cell>(samples, slot.Block, place).Value(place.U)};
}

template <typename Cell>
FieldGradientSample GradientOf(const ScalarField& field, int channel,
                               const Vector3& pointIndex) noexcept
{
  CellPlace place;
  if (!place.Locate(field.Layout(), pointIndex))
  {
    return {};
  }
  const BrickedChannel& samples = field.Channel(channel);
  const BrickedChannel::Slot slot = samples.SlotOf(place.Brick);
  if (slot.Block == BrickedChannel::NotStored)
  {
    return {SampleKind::Constant, slot.Constant, Vector3::Zero()};
  }
  const Cell cell = LoadCell<Cell>(samples, slot.Block, place);
  FieldGradientSample sample{SampleKind::Sampled, cell.Value(place.U), Vector3::Zero()};
  cell.Gradient(place.U, sample.Gradient.data());
  return sample;
}

// Of a material that has a surface in the brick, so that its channels' nodes are stored there.
template <typename Cell>
bool HoldsAt(const ScalarField& field, const FieldMaterial& material,
             const CellPlace& place) noexcept
{
  for (int c = 0; c < material.ConditionCount; ++c)
  {
    const FieldCondition& condition = material.Conditions[c];
    const BrickedChannel& samples = field.Channel(condition.Channel);
    Cell cell = LoadCell<Cell>(samples, samples.SlotOf(place.Brick).Block, place);
    cell.Relate(condition);
    if (!(cell.Value(place.U) >= 0.0))
    {
      return false;
    }
  }
  return true;
}

template <typename Cell>
bool IsInside(const ScalarField& field, int material, const Vector3& pointIndex) noexcept
{
  CellPlace place;
  if (!place.Locate(field.Layout(), pointIndex))
  {
    return false;
  }
  const BrickDirectory::Entry entry = field.Directory()[place.Brick];
  if (entry.Leap > 0)
  {
    return Contains(entry.Word, material);
  }
  const SurfaceBrick& surface = field.Directory().Surface(entry);
  return Contains(surface.Materials, material)
             ? HoldsAt<Cell>(field, field.Material(material), place)
             : Contains(surface.Inside, material);
}

template <typename Cell>
MaterialSet MaterialsAt(const ScalarField& field, const Vector3& pointIndex) noexcept
{
  MaterialSet set = 0;
  for (int material = 0; material < field.MaterialCount(); ++material)
  {
    set |= IsInside<Cell>(field, material, pointIndex) ? OnlyMaterial(material) : 0;
  }
  return set;
}

bool IsTrilinear(const ScalarField& field) noexcept
{
  return field.Interpolation() == FieldInterpolation::Trilinear;
}
} // namespace

FieldSample FieldSampler::ValueIndex(int channel, const Vector3& pointIndex) const noexcept
{
  return IsTrilinear(*this->Data) ? ValueOf<TrilinearCell>(*this->Data, channel, pointIndex)
                                  : ValueOf<TricubicCell>(*this->Data, channel, pointIndex);
}

FieldSample FieldSampler::ValueWorld(int channel, const Vector3& pointWorld) const noexcept
{
  return this->ValueIndex(channel, this->Data->Grid().PointIndex(pointWorld));
}

FieldGradientSample FieldSampler::ValueAndGradientIndex(int channel,
                                                        const Vector3& pointIndex) const noexcept
{
  return IsTrilinear(*this->Data) ? GradientOf<TrilinearCell>(*this->Data, channel, pointIndex)
                                  : GradientOf<TricubicCell>(*this->Data, channel, pointIndex);
}

FieldGradientSample FieldSampler::ValueAndGradientWorld(int channel,
                                                        const Vector3& pointWorld) const noexcept
{
  const FieldGrid& grid = this->Data->Grid();
  FieldGradientSample sample = this->ValueAndGradientIndex(channel, grid.PointIndex(pointWorld));
  sample.Gradient = grid.GradientWorld(sample.Gradient);
  return sample;
}

bool FieldSampler::IsInsideIndex(int material, const Vector3& pointIndex) const noexcept
{
  return IsTrilinear(*this->Data) ? IsInside<TrilinearCell>(*this->Data, material, pointIndex)
                                  : IsInside<TricubicCell>(*this->Data, material, pointIndex);
}

bool FieldSampler::IsInsideWorld(int material, const Vector3& pointWorld) const noexcept
{
  return this->IsInsideIndex(material, this->Data->Grid().PointIndex(pointWorld));
}

MaterialSet FieldSampler::MaterialsIndex(const Vector3& pointIndex) const noexcept
{
  return IsTrilinear(*this->Data) ? MaterialsAt<TrilinearCell>(*this->Data, pointIndex)
                                  : MaterialsAt<TricubicCell>(*this->Data, pointIndex);
}

MaterialSet FieldSampler::MaterialsWorld(const Vector3& pointWorld) const noexcept
{
  return this->MaterialsIndex(this->Data->Grid().PointIndex(pointWorld));
}

void FieldSampler::AreInsideIndex(int material, const Vector3* pointsIndex, std::size_t count,
                                  unsigned char* inside) const noexcept
{
  for (std::size_t p = 0; p < count; ++p)
  {
    inside[p] = this->IsInsideIndex(material, pointsIndex[p]) ? 1 : 0;
  }
}

void FieldSampler::AreInsideWorld(int material, const Vector3* pointsWorld, std::size_t count,
                                  unsigned char* inside) const noexcept
{
  for (std::size_t p = 0; p < count; ++p)
  {
    inside[p] = this->IsInsideWorld(material, pointsWorld[p]) ? 1 : 0;
  }
}
} // namespace palpate
