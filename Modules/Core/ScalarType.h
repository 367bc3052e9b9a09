#pragma once

#include <cstdint>
#include <type_traits>

namespace palpate
{
/// Types of samples, named by their bits.
enum class ScalarType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/// The scalar type of T by its size: long and long long may be the same one.
template <typename T>
constexpr ScalarType ScalarTypeOf() noexcept
{
  static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8);
  if constexpr (std::is_floating_point_v<T>)
  {
    return sizeof(T) == 4 ? ScalarType::Float32 : ScalarType::Float64;
  }
  else
  {
    constexpr int Widths = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 2 : sizeof(T) == 4 ? 4 : 6;
    return static_cast<ScalarType>(Widths + (std::is_unsigned_v<T> ? 1 : 0));
  }
}

/// The index that kernels use for a storage type: of the types with 32 bits or more, only floating
/// point is stored.
constexpr int StoredNumber(ScalarType type) noexcept
{
  return type == ScalarType::Float32 ? 4 : type == ScalarType::Float64 ? 5 : static_cast<int>(type);
}

constexpr std::size_t BytesOf(ScalarType type) noexcept
{
  constexpr std::size_t Bytes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return Bytes[static_cast<int>(type)];
}

/// Calls visitor(pointer) with the pointer's actual type.
template <typename Visitor>
decltype(auto) VisitScalars(const void* samples, ScalarType type, const Visitor& visitor)
{
  switch (type)
  {
  case ScalarType::Int8:
    return visitor(static_cast<const std::int8_t*>(samples));
  case ScalarType::UInt8:
    return visitor(static_cast<const std::uint8_t*>(samples));
  case ScalarType::Int16:
    return visitor(static_cast<const std::int16_t*>(samples));
  case ScalarType::UInt16:
    return visitor(static_cast<const std::uint16_t*>(samples));
  case ScalarType::Int32:
    return visitor(static_cast<const std::int32_t*>(samples));
  case ScalarType::UInt32:
    return visitor(static_cast<const std::uint32_t*>(samples));
  case ScalarType::Int64:
    return visitor(static_cast<const std::int64_t*>(samples));
  case ScalarType::UInt64:
    return visitor(static_cast<const std::uint64_t*>(samples));
  case ScalarType::Float32:
    return visitor(static_cast<const float*>(samples));
  case ScalarType::Float64:
    break;
  }
  return visitor(static_cast<const double*>(samples));
}
} // namespace palpate
