#pragma once

#include "ContentDigest.h"
#include "RadialModel.h"
#include "SofteningSettings.h"
#include "TissueMap.h"

#include <string>
#include <string_view>

namespace palpate
{
/// Identifies what a softening is made from: the model, the settings' numbers, the samples of the
/// tissue, and the version of the numerics. Names of files do not count.
class SofteningKey
{
public:
  SofteningKey(const RadialModel& model, const SofteningSettings& settings);

  /// Voxels that are used in a way that the word says, with a modulus or another number.
  void Add(std::string_view use, const TissueMap::Samples& samples, double number);
  /// 32 hexadecimal digits.
  std::string Text() const;

private:
  void AddNumber(double number);
  void AddVector(const Vector3& vector);

  ContentDigest First;
  ContentDigest Second; // begins differently, so that chance does not make both equal
};
} // namespace palpate
