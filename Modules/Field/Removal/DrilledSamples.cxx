#include "DrilledSamples.h"

#include "DistanceBox.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace palpate
{
namespace
{
template <typename T>
T Rounded(double value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return static_cast<T>(value);
  }
  else
  {
    const auto lowest = static_cast<double>(std::numeric_limits<T>::lowest());
    const auto highest = static_cast<double>(std::numeric_limits<T>::max());
    // The largest 64-bit integers are not exact as doubles: clamp values that would round beyond
    // them.
    return value >= highest  ? std::numeric_limits<T>::max()
           : value <= lowest ? std::numeric_limits<T>::lowest()
                             : static_cast<T>(std::nearbyint(value));
  }
}

// For type T, computed in Kept.
template <typename Kept, typename T>
void WriteRow(const NodeCut& cut, const float* distances, int count, T* row)
{
  for (int i = 0; i < count; ++i)
  {
    const auto before = static_cast<Kept>(row[i]);
    const Kept after = cut.Apply(before, static_cast<Kept>(distances[i]));
    row[i] = after != before ? Rounded<T>(static_cast<double>(after)) : row[i];
  }
}

template <typename T>
void CopySlice(const FieldSamples& original, const T* data, const std::array<int, 3>& nodes, int k,
               T* slice)
{
  std::fill_n(slice, static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]),
              Rounded<T>(original.Outside));
  const int z = k - original.StartIndex[2];
  for (int y = 0; y < original.Size[1] && z >= 0 && z < original.Size[2]; ++y)
  {
    const auto row = static_cast<std::size_t>(original.StartIndex[1] + y);
    std::copy_n(data + original.Offset(0, y, z), original.Size[0],
                slice + row * static_cast<std::size_t>(nodes[0]) + original.StartIndex[0]);
  }
}
} // namespace

void WriteDrilledSamples(const RemovedDistances& removed, const NodeCut& cut, ScalarType kept,
                         const FieldSamples& original, void* drilled)
{
  const std::array<int, 3>& nodes = removed.Grid().Size();
  DistanceBox distances;
  const auto write = [&](const auto* data)
  {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(data)>>;
    auto* slice = static_cast<T*>(drilled);
    for (int k = 0; k < nodes[2]; ++k)
    {
      CopySlice(original, data, nodes, k, slice);
      const bool isCut = distances.Gather(removed, {{0, 0, k}, {nodes[0] - 1, nodes[1] - 1, k}});
      for (int j = 0; j < nodes[1]; ++j, slice += nodes[0])
      {
        if (isCut)
        {
          kept == ScalarType::Float64
              ? WriteRow<double>(cut, distances.Row(0, j, k), nodes[0], slice)
              : WriteRow<float>(cut, distances.Row(0, j, k), nodes[0], slice);
        }
      }
    }
  };
  VisitScalars(original.Data, original.Type, write);
}
} // namespace palpate
