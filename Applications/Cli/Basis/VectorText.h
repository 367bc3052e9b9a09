#pragma once

#include "Vector3.h"

#include <string>

namespace palpate::cli
{
/// The three finite numbers of "x,y,z". Throws InputError, naming `subject` (an option) and the
/// word.
Vector3 ParseVector(const std::string& subject, const std::string& word);
} // namespace palpate::cli
