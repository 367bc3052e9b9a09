#pragma once

#include <stdexcept>

namespace palpate
{
/// Bad input. what() is one sentence for the user that names the file, the fact and the fix.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace palpate
