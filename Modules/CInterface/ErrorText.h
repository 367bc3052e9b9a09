#pragma once

#include "Status.h"
#include "Vector3.h"
#include "palpate.h"

#include <exception>
#include <string>

namespace palpate
{
/// Writes a message, shortened where it is too long; nothing if `error` is null.
void SetError(palpate_error* error, const std::string& message) noexcept;

/// 1 for a success; else 0, with the message.
int Told(const Status& status, palpate_error* error) noexcept;

/// The result of `body`, which may throw; an empty one, with the message, if it does. No exception
/// may reach a program in C.
template <typename Body>
auto Guarded(palpate_error* error, Body body) noexcept -> decltype(body())
{
  try
  {
    return body();
  }
  catch (const std::exception& problem)
  {
    SetError(error, problem.what());
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
