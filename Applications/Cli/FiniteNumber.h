#pragma once

#include <CLI/CLI.hpp>

namespace palpate::cli
{
/// Checks that the word of an option is a finite number in a range; CLI::Range lets nan through.
class FiniteNumber : public CLI::Validator
{
public:
  /// Both ends are in the range.
  static FiniteNumber Between(double low, double high);
  static FiniteNumber Positive();
  static FiniteNumber Any();

private:
  FiniteNumber(double low, double high, bool lowIsIn, const std::string& range);
};
} // namespace palpate::cli
