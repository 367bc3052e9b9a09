#include "NiftiVoxels.h"

#include "GzipFile.h"
#include "Refusal.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
  const int whole = this->IsScaled() ? VTK_FLOAT : 0;
  switch (this->Header.Type)
  {
  case NiftiType::UnsignedChar:
    return whole != 0 ? whole : VTK_UNSIGNED_CHAR;
  case NiftiType::SignedChar:
    return whole != 0 ? whole : VTK_SIGNED_CHAR;
  case NiftiType::UnsignedShort:
    return whole != 0 ? whole : VTK_UNSIGNED_SHORT;
  case NiftiType::Short:
    return whole != 0 ? whole : VTK_SHORT;
  case NiftiType::UnsignedInt:
    return whole != 0 ? whole : VTK_UNSIGNED_INT;
  case NiftiType::Int:
    return whole != 0 ? whole : VTK_INT;
  case NiftiType::UnsignedLong:
    return whole != 0 ? whole : VTK_UNSIGNED_LONG;
  case NiftiType::Long:
    return whole != 0 ? whole : VTK_LONG;
  case NiftiType::Float:
    return VTK_FLOAT;
  case NiftiType::Double:
    return VTK_DOUBLE;
  }
  return 0;
}

void NiftiVoxels::ReadInto(void* buffer) const
{
  const Scaling scaling{this->IsScaled(), this->Header.Slope, this->Header.Intercept};
  GzipFile file(this->File);
  file.Skip(this->Header.VoxelOffset);
  const auto decode = [&](auto stored)
  { DecodeTo<decltype(stored)>(file, this->Header, scaling, buffer); };
  switch (this->Header.Type)
  {
  case NiftiType::UnsignedChar:
    decode(std::uint8_t{});
    break;
  case NiftiType::SignedChar:
    decode(std::int8_t{});
    break;
  case NiftiType::UnsignedShort:
    decode(std::uint16_t{});
    break;
  case NiftiType::Short:
    decode(std::int16_t{});
    break;
  case NiftiType::UnsignedInt:
    decode(std::uint32_t{});
    break;
  case NiftiType::Int:
    decode(std::int32_t{});
    break;
  case NiftiType::UnsignedLong:
    decode(std::uint64_t{});
    break;
  case NiftiType::Long:
    decode(std::int64_t{});
    break;
  case NiftiType::Float:
    decode(float{});
    break;
  case NiftiType::Double:
    decode(double{});
    break;
  }
  file.ReadToEnd();
}
} // namespace palpate
