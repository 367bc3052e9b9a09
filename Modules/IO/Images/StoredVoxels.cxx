#include "StoredVoxels.h"

#include "DecimalText.h"
#include "GzipFile.h"
#include "HeaderBytes.h"
#include "Refusal.h"
#include "WholeFile.h"
#include "ZlibCheck.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t BlockVoxels = 1U << 14;

// Converts stored values to the image's values.
struct Scaling
{
  bool IsNeeded;
  double Slope;
  double Intercept;
};

template <typename T>
void ReverseBytes(std::vector<T>& values)
{
  for (T& value : values)
  {
    auto* bytes = reinterpret_cast<unsigned char*>(&value);
    std::reverse(bytes, bytes + sizeof(T));
  }
}

// Whole numbers are converted to float before scaling, as in ITK.
template <typename Stored, typename Value>
void Decode(GzipFile& file, const VoxelLayout& layout, const Scaling& scaling, Value* target)
{
  auto left = static_cast<std::size_t>(layout.Voxels);
  std::vector<Stored> block(std::min(left, BlockVoxels));
  for (; left > 0; left -= block.size())
  {
    block.resize(std::min(left, BlockVoxels));
    file.Read(block.data(), block.size() * sizeof(Stored));
    if (layout.IsSwapped)
    {
      ReverseBytes(block);
    }
    target = std::transform(
        block.begin(), block.end(), target,
        [&scaling](Stored stored)
        {
          const auto value = static_cast<Value>(stored);
          return scaling.IsNeeded ? static_cast<Value>(static_cast<double>(value) * scaling.Slope +
                                                       scaling.Intercept)
                                  : value;
        });
  }
}

template <typename Stored>
void DecodeTo(GzipFile& file, const VoxelLayout& layout, const Scaling& scaling, void* buffer)
{
  if (scaling.IsNeeded && std::is_integral_v<Stored>)
  {
    return Decode<Stored>(file, layout, scaling, static_cast<float*>(buffer));
  }
  Decode<Stored>(file, layout, scaling, static_cast<Stored*>(buffer));
}

std::uint64_t VolumeBytes(const VoxelLayout& layout)
{
  return static_cast<std::uint64_t>(layout.Voxels) *
         static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(layout.Type));
}
} // namespace

std::int64_t CountVoxels(const std::filesystem::path& file, const std::array<int, 3>& size)
{
  if (!(static_cast<double>(size[0]) * size[1] * size[2] <= 1e15))
  {
    Refuse(file,
           "has a damaged header (" + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
               " x " + std::to_string(size[2]) + " voxels)",
           "copy or export it again");
  }
  return static_cast<std::int64_t>(size[0]) * size[1] * size[2];
}

StoredVoxels::StoredVoxels(VoxelLayout layout) : Stored(std::move(layout)) {}

void StoredVoxels::CheckLength() const
{
  // In double, which no declared size overflows.
  const double needed = static_cast<double>(this->Stored.Offset) +
                        static_cast<double>(this->Stored.Voxels) *
                            static_cast<double>(this->Stored.Volumes) *
                            vtkDataArray::GetDataTypeSize(this->Stored.Type);
  const std::uintmax_t length = InputFileSize(this->Stored.File);
  if (HeaderBytes(this->Stored.File, 1).IsCompressed())
  {
    CheckInflatedSize(this->Stored.File, static_cast<double>(length), needed);
  }
  else if (static_cast<double>(length) < needed)
  {
    Refuse(this->Stored.File,
           "is truncated: its header declares " + FixedText(needed, 0) + " bytes but it has " +
               std::to_string(length),
           "copy or export it again");
  }
}

bool StoredVoxels::IsScaled() const
{
  constexpr double tiny = std::numeric_limits<double>::epsilon();
  return std::abs(this->Stored.Slope - 1.0) > tiny || std::abs(this->Stored.Intercept) > tiny;
}

int StoredVoxels::ScalarType() const
{
  const int type = this->Stored.Type;
  return this->IsScaled() && type != VTK_DOUBLE ? VTK_FLOAT : type;
}

void StoredVoxels::ReadInto(void* buffer, std::int64_t volume) const
{
  const Scaling scaling{this->IsScaled(), this->Stored.Slope, this->Stored.Intercept};
  const std::uint64_t bytes = VolumeBytes(this->Stored);
  const auto behind = static_cast<std::uint64_t>(this->Stored.Volumes - 1 - volume);
  GzipFile file(this->Stored.File);
  file.Skip(this->Stored.Offset + static_cast<std::uint64_t>(volume) * bytes);
  switch (this->Stored.Type)
  {
    vtkTemplateMacro(DecodeTo<VTK_TT>(file, this->Stored, scaling, buffer));
  }
  file.Skip(behind * bytes);
  file.ReadToEnd();
}
} // namespace palpate
