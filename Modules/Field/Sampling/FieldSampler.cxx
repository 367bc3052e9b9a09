#include "FieldSampler.h"

#include "CellPlace.h"
#include "InsideKernelChoice.h"
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

template <typename Cell>
bool Holds(const FieldCondition& condition, const BrickedChannel& samples, std::uint32_t block,
           const CellPlace& place) noexcept
{
  Cell cell = LoadCell<Cell>(samples, block, place);
  cell.Relate(condition);
  return cell.Value(place.U) >= 0.0;
}

template <typename Cell>
bool IsInside(const ScalarField& field, int number, const Vector3& pointIndex) noexcept
{
  CellPlace place;
  if (!place.Locate(field.Layout(), pointIndex))
  {
    return false;
  }
  const std::uint32_t code = field.Map(number)[place.Brick];
  if (code >= MaterialMap::Filled)
  {
    return code == MaterialMap::Filled;
  }
  const FieldMaterial& material = field.Material(number);
  bool isInside = Holds<Cell>(material.Conditions[0], field.Channel(material.Conditions[0].Channel),
                              code, place);
  for (int c = 1; c < material.ConditionCount && isInside; ++c)
  {
    const BrickedChannel& samples = field.Channel(material.Conditions[c].Channel);
    isInside =
        Holds<Cell>(material.Conditions[c], samples, samples.SlotOf(place.Brick).Block, place);
  }
  return isInside;
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

// `toIndex` is applied to points - origin.
inside::Material DescribeForKernel(const ScalarField& field, int number, const Matrix3& toIndex,
                                   const Vector3& origin) noexcept
{
  const FieldCondition& condition = field.Material(number).Conditions[0];
  const BrickedChannel& samples = field.Channel(condition.Channel);
  inside::Material material{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    for (int column = 0; column < 3; ++column)
    {
      material.ToIndex[3 * axis + column] = toIndex(axis, column);
    }
    material.Origin[axis] = origin[axis];
    material.LastCell[axis] = field.Layout().Nodes[a] - 2;
    material.Bricks[axis] = field.Layout().Bricks[a];
  }
  material.Codes = field.Map(number).Data();
  material.Filled = MaterialMap::Filled;
  material.Blocks = samples.BlockData();
  material.Stride = samples.BlockStride();
  material.Iso = condition.Iso;
  material.Sign = condition.Sign();
  return material;
}

bool IsForKernel(const ScalarField& field, int number, std::size_t count) noexcept
{
  return count > 0 && field.Material(number).ConditionCount == 1;
}

void RunKernel(const inside::Kernel& kernel, const ScalarField& field, int number,
               const inside::Material& material, const Vector3* points, std::size_t count,
               unsigned char* inside) noexcept
{
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  const int channel = field.Material(number).Conditions[0].Channel;
  const int type = StoredNumber(field.Channel(channel).StoredType());
  static_assert(inside::Shift == BrickLayout::Shift);
  const auto test = IsTrilinear(field) ? kernel.Trilinear[type] : kernel.Tricubic[type];
  test(material, points->data(), static_cast<long>(count), inside);
}
} // namespace

FieldSampler::FieldSampler(std::shared_ptr<const ScalarField> field, InstructionSet set)
    : Data(std::move(field)), Kernel(&inside::KernelFor(set))
{
}

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
  const ScalarField& field = *this->Data;
  if (IsForKernel(field, material, count))
  {
    RunKernel(*this->Kernel, field, material,
              DescribeForKernel(field, material, Matrix3::Identity(), Vector3::Zero()), pointsIndex,
              count, inside);
    return;
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    inside[p] = this->IsInsideIndex(material, pointsIndex[p]) ? 1 : 0;
  }
}

void FieldSampler::AreInsideWorld(int material, const Vector3* pointsWorld, std::size_t count,
                                  unsigned char* inside) const noexcept
{
  const ScalarField& field = *this->Data;
  if (IsForKernel(field, material, count))
  {
    const FieldGrid& grid = field.Grid();
    RunKernel(*this->Kernel, field, material,
              DescribeForKernel(field, material, grid.WorldToIndex(), grid.OriginWorld()),
              pointsWorld, count, inside);
    return;
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    inside[p] = this->IsInsideWorld(material, pointsWorld[p]) ? 1 : 0;
  }
}
} // namespace palpate
