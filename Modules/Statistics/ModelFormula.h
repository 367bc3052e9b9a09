#pragma once

#include "Status.h"

#include <string>
#include <vector>

namespace palpate
{
/// A covariate as a formula uses it.
struct FormulaVariable
{
  enum class Transform
  {
    None,
    Log,
    Log2,
    Log10,
    Sqrt,
    Exp,
    Power, ///< I(name^exponent)
    Factor ///< numbers as categories
  };
  std::string Column;
  Transform Function = Transform::None;
  int Exponent = 1;

  std::string Text() const; ///< as written: log(psa)
};

/// The right side of a linear model in the notation of Wilkinson and Rogers ("Symbolic description
/// of factorial models for analysis of variance", Applied Statistics 22 (1973) 392) as R writes it:
/// `~ age + log(psa) + group * sex`. It has + : * and parentheses of functions; names with other
/// characters than letters, digits, points and underscores stand in back quotes. The intercept is
/// always there.
class ModelFormula
{
public:
  using Term = std::vector<FormulaVariable>; ///< several variables: their interaction

  /// Fails with the place of the first character that is not understood.
  static Status Parse(const std::string& text, ModelFormula& formula);

  /// Main effects first, then interactions of two, and so on; none twice.
  const std::vector<Term>& Terms() const noexcept { return this->Content; }
  /// Each column that is used, once.
  std::vector<std::string> Columns() const;
  std::string Text() const;

private:
  std::vector<Term> Content;
};

/// The name of a term: `age`, `log(psa):group`.
std::string TextOf(const ModelFormula::Term& term);
} // namespace palpate
