#include "VectorText.h"

#include "DecimalText.h"
#include "InputError.h"

#include <algorithm>
#include <sstream>

namespace palpate::cli
{
Vector3 ParseVector(const std::string& subject, const std::string& word)
{
  Vector3 vector = Vector3::Zero();
  std::istringstream parts(word);
  bool good = std::count(word.begin(), word.end(), ',') == 2;
  std::string part;
  for (int k = 0; good && k < 3; ++k)
  {
    std::getline(parts, part, ',');
    const std::optional<double> number = ParseNumber(part);
    good = number.has_value();
    vector[k] = number.value_or(0.0);
  }
  if (!good)
  {
    throw InputError(subject + " " + word + " is not three numbers; give x,y,z.");
  }
  return vector;
}
} // namespace palpate::cli
