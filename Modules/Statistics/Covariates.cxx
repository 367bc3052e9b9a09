#include "Covariates.h"

#include "DecimalText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
bool IsMissingText(const std::string& text)
{
  std::string word;
  for (const char letter : text)
  {
    if (std::isspace(static_cast<unsigned char>(letter)) == 0)
    {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  constexpr std::array<const char*, 14> Words{{"", "na", "n/a", "nan", "null", "?", "#n/a", "#na",
                                               "#null!", "#value!", "#div/0!", "#ref!", "#name?",
                                               "#num!"}};
  return std::any_of(Words.begin(), Words.end(),
                     [&](const char* missing) { return word == missing; });
}
} // namespace

Covariate::Covariate(std::string name, std::vector<std::string> texts)
    : Title(std::move(name)), Values(std::move(texts)), FirstWord(Values.size())
{
  for (std::size_t row = 0; row < this->Values.size(); ++row)
  {
    const bool isMissing = IsMissingText(this->Values[row]);
    const auto number = ParseNumber(this->Values[row]);
    this->Missing.push_back(isMissing);
    this->Numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (!isMissing && !number)
    {
      this->FirstWord = std::min(this->FirstWord, row);
    }
  }
}

double Covariate::LikelyMissingCode() const
{
  constexpr std::array<double, 10> Codes{
      {-9.0, -99.0, -999.0, -9999.0, -99999.0, -888.0, -777.0, 999.0, 9999.0, 99999.0}};
  constexpr double Far = 5.0; // times the largest other value
  for (const double code : Codes)
  {
    bool isThere = false;
    double largest = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const double value : this->Numbers)
    {
      isThere = isThere || value == code;
      const bool isCode = std::find(Codes.begin(), Codes.end(), value) != Codes.end();
      if (!isCode && std::isfinite(value))
      {
        largest = std::max(largest, value);
        least = std::min(least, value);
      }
    }
    if (isThere && std::isfinite(least) && least >= 0.0 && (code < 0.0 || code > Far * largest))
    {
      return code;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void CovariateTable::Add(const std::string& name, std::vector<std::string> texts)
{
  if (this->Find(name) == nullptr)
  {
    this->Content.emplace_back(name, std::move(texts));
  }
}

const Covariate* CovariateTable::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Content.begin(), this->Content.end(),
                                  [&](const Covariate& one) { return one.Name() == name; });
  return found == this->Content.end() ? nullptr : &*found;
}
} // namespace palpate
