#pragma once

#include <string>
#include <vector>

namespace palpate::cli
{
/// The word that `mistyped` is most likely meant to be: the one with the fewest letters added, left
/// out, changed or exchanged with their neighbour, at most a third of its length. Empty if none is
/// that near; the first of equally near ones.
std::string NearestWord(const std::string& mistyped, const std::vector<std::string>& words);
} // namespace palpate::cli
