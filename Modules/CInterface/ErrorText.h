#pragma once

#include "Status.h"
#include "Vector3.h"
#include "palpate.h"

#include <cstddef>
#include <exception>
#include <initializer_list>
#include <string>

namespace palpate
{
/// Writes a message, shortened where it is too long; nothing if `error` is null.
void SetError(palpate_error* error, const std::string& message) noexcept;

/// 1 for a success; else 0, with the message.
int Told(const Status& status, palpate_error* error) noexcept;

/// An array that a function needs, and how many elements it has; none of 0 may be NULL.
struct Argument
{
  const void* Array;
  const char* Name;
  std::size_t Count = 1;
};

/// Elements of any array, well above what a machine holds of what is counted: beyond it a count is
/// wrong.
constexpr std::size_t MostElements = std::size_t{1} << 28U;

/// Whether none of them is NULL or larger than MostElements; else the message.
bool AreGiven(std::initializer_list<Argument> needed, palpate_error* error) noexcept;

/// The message of what was thrown.
void SetError(palpate_error* error, const std::exception& problem) noexcept;

/// The result of `body`, which may throw; an empty one, with the message, if it does or something
/// that it needs is not given. No exception may reach a program in C.
template <typename Body>
auto Guarded(palpate_error* error, std::initializer_list<Argument> needed, Body body) noexcept
    -> decltype(body())
{
  if (!AreGiven(needed, error))
  {
    return {};
  }
  try
  {
    return body();
  }
  catch (const std::exception& problem)
  {
    SetError(error, problem);
  }
  return {};
}

inline Vector3 VectorOf(const double numbers[3])
{
  return {numbers[0], numbers[1], numbers[2]};
}

inline void Copy(const Vector3& vector, double numbers[3])
{
  numbers[0] = vector[0];
  numbers[1] = vector[1];
  numbers[2] = vector[2];
}
} // namespace palpate
