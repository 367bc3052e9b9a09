#pragma once

#include "Vector3.h"

#include <string>

namespace palpate::cli
{
/// The three finite numbers of "x,y,z". Throws InputError, naming `subject` (an option or a place
/// in a file) and the word.
Vector3 ParseVector(const std::string& subject, const std::string& word);

/// "x,y,z" with all digits.
std::string VectorText(const Vector3& vector);
} // namespace palpate::cli
