#include "NiftiVoxels.h"

#include "GzipFile.h"
#include "Refusal.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
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
void Decode(GzipFile& file, const NiftiHeader& header, const Scaling& scaling, Value* target)
{
  auto left = static_cast<std::size_t>(header.Size[0]) * static_cast<std::size_t>(header.Size[1]) *
              static_cast<std::size_t>(header.Size[2]);
  std::vector<Stored> block(std::min(left, BlockVoxels));
  for (; left > 0; left -= block.size())
  {
    block.resize(std::min(left, BlockVoxels));
    file.Read(block.data(), block.size() * sizeof(Stored));
    if (header.IsSwapped)
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
void DecodeTo(GzipFile& file, const NiftiHeader& header, const Scaling& scaling, void* buffer)
{
  if (scaling.IsNeeded && std::is_integral_v<Stored>)
  {
    return Decode<Stored>(file, header, scaling, static_cast<float*>(buffer));
  }
  Decode<Stored>(file, header, scaling, static_cast<Stored*>(buffer));
}
} // namespace

NiftiVoxels::NiftiVoxels(const std::filesystem::path& file, const NiftiHeader& header)
    : File(file), Header(header)
{
}

bool NiftiVoxels::IsScaled() const
{
  constexpr double tiny = std::numeric_limits<double>::epsilon();
  return std::abs(this->Header.Slope - 1.0) > tiny || std::abs(this->Header.Intercept) > tiny;
}

int NiftiVoxels::ScalarType() const
{
  const int type = this->Header.VoxelType;
  return this->IsScaled() && type != VTK_DOUBLE ? VTK_FLOAT : type;
}

void NiftiVoxels::ReadInto(void* buffer) const
{
  const Scaling scaling{this->IsScaled(), this->Header.Slope, this->Header.Intercept};
  GzipFile file(this->File);
  file.Skip(this->Header.VoxelOffset);
  switch (this->Header.VoxelType)
  {
    vtkTemplateMacro(DecodeTo<VTK_TT>(file, this->Header, scaling, buffer));
  }
  file.ReadToEnd();
}
} // namespace palpate
