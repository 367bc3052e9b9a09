#include "CoarseField.h"

#include "FieldBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

namespace palpate
{
namespace
{
// A coarse node lies on every other fine one and takes in those that are at most so far from it. A
// trilinear value at a fine node is a mean of coarse nodes each of which has taken that node in, so
// it holds there at least as much; between fine nodes both are means with the same weights. A
// B-spline's value is a mean of coefficients up to two nodes beyond.
int PoolReach(FieldInterpolation fine) noexcept
{
  return fine == FieldInterpolation::Trilinear ? 1 : 3;
}

FieldGrid CoarseGridOf(const FieldGrid& fine)
{
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = fine.Size()[axis] / 2 + 1;
  }
  return {size, fine.OriginWorld(), 2.0 * fine.Spacing(), fine.Direction()};
}

// Coarse nodes along an axis that take in a fine one.
struct CoarseRange
{
  int First;
  int Last;

  CoarseRange(int firstNode, int lastNode, int reach, int coarseNodes)
      : First(std::max(0, (firstNode - reach + 1) >> 1)),
        Last(std::min(coarseNodes - 1, (lastNode + reach) >> 1))
  {
  }
  int Count() const { return this->Last - this->First + 1; }
};

// One condition's channel, pooled. What holds more is larger if the condition asks for at least a
// value, else smaller; here it is always larger.
template <typename T>
class PooledChannel
{
public:
  PooledChannel(const ScalarField& fine, int material, const FieldCondition& condition,
                const FieldGrid& grid)
      : Fine(fine), Map(fine.Map(material)), Channel(fine.Channel(condition.Channel)),
        IsOnly(fine.Material(material).ConditionCount == 1), Grid(grid),
        IsWhole(Channel.StoredType() < ScalarType::Float32), Sign(static_cast<T>(condition.Sign())),
        Limit(condition.Sign() * condition.Iso), Reach(PoolReach(fine.Interpolation())),
        Values(grid.NodeCount(), std::numeric_limits<T>::lowest())
  {
  }

  std::vector<T> Run()
  {
    const BrickLayout& layout = this->Fine.Layout();
    for (int k = 0; k < layout.Bricks[2]; ++k)
    {
      for (int j = 0; j < layout.Bricks[1]; ++j)
      {
        for (int i = 0; i < layout.Bricks[0]; ++i)
        {
          this->Take({i, j, k});
        }
      }
    }
    for (T& value : this->Values)
    {
      value *= this->Sign;
    }
    return std::move(this->Values);
  }

private:
  void Take(const std::array<int, 3>& brick)
  {
    const BrickLayout& layout = this->Fine.Layout();
    const std::size_t number = layout.Number(brick[0], brick[1], brick[2]);
    const BrickedChannel::Slot slot = this->Channel.SlotOf(number);
    const bool isStored = slot.Block != BrickedChannel::NotStored;
    std::array<CoarseRange, 3> ranges{this->RangeOf(brick, 0), this->RangeOf(brick, 1),
                                      this->RangeOf(brick, 2)};
    if (!isStored)
    {
      this->Raise(ranges,
                  [value = this->Constant(number, slot.Constant)](int, int, int) { return value; });
      return;
    }
    this->Pool(brick, slot.Block, ranges);
    this->Raise(ranges,
                [&](int i, int j, int k)
                {
                  const int row = k * ranges[1].Count() + j;
                  return this->Along[static_cast<std::size_t>(row * ranges[0].Count() + i)];
                });
  }

  CoarseRange RangeOf(const std::array<int, 3>& brick, std::size_t axis) const
  {
    const BrickLayout& layout = this->Fine.Layout();
    const int first = layout.Cells * brick[axis] - layout.Apron();
    return {std::max(first, 0), std::min(first + layout.Side, layout.Nodes[axis]) - 1, this->Reach,
            this->Grid.Size()[axis]};
  }

  // Of a brick that no surface passes: on the side on which it lies, which a rounded constant may
  // not say.
  T Constant(std::size_t brick, float constant) const
  {
    const T exact = this->Sign * static_cast<T>(constant);
    const T value = this->IsWhole ? std::round(exact) : exact;
    const std::uint32_t code = this->Map[brick];
    if (this->IsOnly && code == MaterialMap::Filled)
    {
      return std::max(value, this->LeastInside());
    }
    if (this->IsOnly && code == MaterialMap::Absent)
    {
      const T inside = this->LeastInside();
      return std::min(value, this->IsWhole
                                 ? inside - T{1}
                                 : std::nextafter(inside, std::numeric_limits<T>::lowest()));
    }
    return value;
  }
  T LeastInside() const
  {
    const auto limit = static_cast<T>(this->IsWhole ? std::ceil(this->Limit) : this->Limit);
    return limit < this->Limit ? std::nextafter(limit, std::numeric_limits<T>::max()) : limit;
  }

  // The most of a brick's nodes, axis after axis, into Along.
  void Pool(const std::array<int, 3>& brick, std::uint32_t block,
            const std::array<CoarseRange, 3>& ranges)
  {
    const BrickLayout& layout = this->Fine.Layout();
    this->Gather(block);
    std::array<int, 3> size{layout.Side, layout.Side, layout.Side};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int first = layout.Cells * brick[axis] - layout.Apron();
      this->PoolAxis(axis, first, layout.Nodes[axis], ranges[axis], size);
      size[axis] = ranges[axis].Count();
    }
  }

  void Gather(std::uint32_t block)
  {
    const BrickLayout& layout = this->Fine.Layout();
    const std::size_t nodes = layout.NodesOfBrick();
    this->Along.resize(nodes);
    VisitScalars(this->Channel.BlockAt(block), this->Channel.StoredType(),
                 [&](const auto* from)
                 {
                   std::transform(from, from + nodes, this->Along.begin(),
                                  [this](auto node) { return this->Sign * static_cast<T>(node); });
                 });
  }

  // Of `size` nodes, of which those along the axis begin at fine node `first`. What a brick has
  // beyond the `nodes` of the grid are copies of others, which count where they are.
  void PoolAxis(std::size_t axis, int first, int nodes, const CoarseRange& range,
                const std::array<int, 3>& size)
  {
    const int low = std::max(0, -first);
    const int high = std::min(size[axis], nodes - first) - 1;
    std::array<int, 3> to = size;
    to[axis] = range.Count();
    this->Next.assign(static_cast<std::size_t>(to[0] * to[1] * to[2]),
                      std::numeric_limits<T>::lowest());
    std::array<int, 3> at{};
    for (at[2] = 0; at[2] < to[2]; ++at[2])
    {
      for (at[1] = 0; at[1] < to[1]; ++at[1])
      {
        for (at[0] = 0; at[0] < to[0]; ++at[0])
        {
          const int middle = 2 * (range.First + at[axis]) - first;
          T& most = this->Next[static_cast<std::size_t>((at[2] * to[1] + at[1]) * to[0] + at[0])];
          std::array<int, 3> from = at;
          const int last = std::min(middle + this->Reach, high);
          for (from[axis] = std::max(middle - this->Reach, low); from[axis] <= last; ++from[axis])
          {
            most = std::max(most, this->Along[static_cast<std::size_t>(
                                      (from[2] * size[1] + from[1]) * size[0] + from[0])]);
          }
        }
      }
    }
    this->Along.swap(this->Next);
  }

  template <typename ValueAt>
  void Raise(const std::array<CoarseRange, 3>& ranges, const ValueAt& valueAt)
  {
    const FieldSamples whole = SamplesOfGrid(this->Values.data(), this->Grid);
    for (int k = 0; k < ranges[2].Count(); ++k)
    {
      for (int j = 0; j < ranges[1].Count(); ++j)
      {
        for (int i = 0; i < ranges[0].Count(); ++i)
        {
          T& value = this->Values[whole.Offset(ranges[0].First + i, ranges[1].First + j,
                                               ranges[2].First + k)];
          value = std::max(value, valueAt(i, j, k));
        }
      }
    }
  }

  const ScalarField& Fine;
  const MaterialMap& Map;
  const BrickedChannel& Channel;
  bool IsOnly; // the material's only condition, so that its map speaks of this channel
  const FieldGrid& Grid;
  bool IsWhole; // its numbers are
  T Sign;
  double Limit;
  int Reach;
  std::vector<T> Values;
  std::vector<T> Along;
  std::vector<T> Next;
};
// As it is stored in the fine field, so that it takes no more.
struct CoarseChannel
{
  std::vector<std::byte> Numbers;
  FieldSamples Samples;

  CoarseChannel(const ScalarField& fine, int material, const FieldCondition& condition,
                const FieldGrid& grid)
  {
    const ScalarType type = fine.Channel(condition.Channel).StoredType();
    type == ScalarType::Float64
        ? this->Keep(PooledChannel<double>(fine, material, condition, grid).Run(), type, grid)
        : this->Keep(PooledChannel<float>(fine, material, condition, grid).Run(), type, grid);
  }

private:
  template <typename T>
  void Keep(const std::vector<T>& values, ScalarType type, const FieldGrid& grid)
  {
    this->Numbers.resize(values.size() * BytesOf(type));
    VisitScalars(this->Numbers.data(), type,
                 [&](const auto* as)
                 {
                   using Number = std::remove_const_t<std::remove_pointer_t<decltype(as)>>;
                   auto* numbers = reinterpret_cast<Number*>(this->Numbers.data());
                   std::transform(values.begin(), values.end(), numbers,
                                  [](T value) { return static_cast<Number>(value); });
                 });
    this->Samples = {this->Numbers.data(), type, {0, 0, 0}, grid.Size(), 0.0};
  }
};
} // namespace

int CoarseReach(FieldInterpolation fine) noexcept
{
  constexpr int CoarseCell = 2;
  return CoarseCell + PoolReach(fine);
}

Status MakeCoarseField(const ScalarField& fine, int material,
                       std::shared_ptr<const ScalarField>& coarse)
{
  try
  {
    const FieldGrid grid = CoarseGridOf(fine.Grid());
    const FieldMaterial& made = fine.Material(material);
    std::vector<CoarseChannel> channels;
    channels.reserve(FieldMaterial::MostConditions);
    FieldBuilder builder(grid);
    FieldCondition conditions[FieldMaterial::MostConditions];
    for (int c = 0; c < made.ConditionCount; ++c)
    {
      channels.emplace_back(fine, material, made.Conditions[c], grid);
      conditions[c] = made.Conditions[c];
      conditions[c].Channel = builder.AddChannel(channels.back().Samples);
    }
    made.ConditionCount == 1 ? builder.AddMaterial(conditions[0])
                             : builder.AddMaterial(conditions[0], conditions[1]);
    return builder.Build(coarse);
  }
  catch (const std::bad_alloc&)
  {
    return Status::Failure("There is not enough memory for the coarse field.");
  }
}
} // namespace palpate
