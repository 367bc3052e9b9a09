#include "FieldSampler.h"

#include "InsideKernel.h"
#include "TricubicCell.h"
#include "TrilinearCell.h"

namespace palpate::inside
{
namespace
{
struct PortableSet
{
  typedef double Vector __attribute__((vector_size(16)));
  typedef int Integers __attribute__((vector_size(8)));
  static constexpr int Lanes = 2;
};
const Kernel Portable = Arithmetic<PortableSet>::All();

const Kernel& KernelFor(InstructionSet set) noexcept
{
  return set == InstructionSet::Avx2 ? Avx2 : Portable;
}
} // namespace
} // namespace palpate::inside

namespace palpate
{
namespace
{
// The cell that contains a point, its brick, and the point's position in the cell.
struct CellPlace
{
  std::size_t Brick = 0;
  int FirstNode = 0; // of the cell in its brick's copy of the nodes
  double U[3] = {};  // from 0 to 1 along i, j, k

  // Returns false outside the grid and for NaN. A point on a face between two cells belongs to the
  // one of higher index; on the grid's last face to the last cell.
  bool Locate(const BrickLayout& layout, const Vector3& pointIndex) noexcept
  {
    int cell[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double p = pointIndex[axis];
      const auto a = static_cast<std::size_t>(axis);
      const int last = layout.Nodes[a] - 1;
      if (!(p >= 0.0 && p <= last))
      {
        return false;
      }
      const int below = static_cast<int>(p);
      cell[axis] = below < last ? below : last - 1;
      this->U[axis] = p - cell[axis];
    }
    this->Brick = layout.NumberOfCell(cell[0], cell[1], cell[2]);
    this->FirstNode = layout.FirstNodeOfCell(cell[0], cell[1], cell[2]);
    return true;
  }
};

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

bool IsTrilinear(const ScalarField& field) noexcept
{
  return field.Interpolation() == FieldInterpolation::Trilinear;
}

inside::Material DescribeForKernel(const ScalarField& field, int number) noexcept
{
  const FieldCondition& condition = field.Material(number).Conditions[0];
  const BrickedChannel& samples = field.Channel(condition.Channel);
  inside::Material material{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    for (int column = 0; column < 3; ++column)
    {
      material.ToIndex[3 * axis + column] = field.Grid().WorldToIndex()(axis, column);
    }
    material.Origin[axis] = field.Grid().OriginWorld()[axis];
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

void FieldSampler::AreInsideWorld(int material, const Vector3* pointsWorld, std::size_t count,
                                  unsigned char* inside) const noexcept
{
  const ScalarField& field = *this->Data;
  if (count > 0 && field.Material(material).ConditionCount == 1)
  {
    static_assert(sizeof(Vector3) == 3 * sizeof(double));
    static_assert(inside::Shift == BrickLayout::Shift);
    const int channel = field.Material(material).Conditions[0].Channel;
    const int type = StoredNumber(field.Channel(channel).StoredType());
    const auto test =
        IsTrilinear(field) ? this->Kernel->Trilinear[type] : this->Kernel->Tricubic[type];
    test(DescribeForKernel(field, material), pointsWorld->data(), static_cast<long>(count), inside);
    return;
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    inside[p] = this->IsInsideWorld(material, pointsWorld[p]) ? 1 : 0;
  }
}
} // namespace palpate
