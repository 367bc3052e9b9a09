#pragma once

#include <CLI/CLI.hpp>

namespace palpate::cli
{
/// Checks that an option's word is a finite number in a range; CLI::Range accepts nan.
class FiniteNumber : public CLI::Validator
{
public:
  /// The range includes both ends.
  static FiniteNumber Between(double low, double high);
  static FiniteNumber Positive();
  static FiniteNumber Any();

private:
  FiniteNumber(double low, double high, bool lowIsIn, const std::string& range);
};
} // namespace palpate::cli
