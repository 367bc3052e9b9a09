#pragma once

#include <exception>
#include <string>

namespace palpate
{
/// What a user is told of an exception: the message of an error that Palpate or the system raised,
/// and a message of our own for one of a library, whose text says nothing to a user (no memory, a
/// length or an index that is impossible).
std::string MessageOf(const std::exception& problem);
} // namespace palpate
