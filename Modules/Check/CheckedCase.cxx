#include "CheckedCase.h"

#include "Median.h"
#include "Units.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
struct Pair
{
  CheckedOrgan* Left = nullptr;
  CheckedOrgan* Right = nullptr;
};

std::vector<std::string> WordsOf(const std::string& name)
{
  std::vector<std::string> words(1);
  char before = '_';
  for (const char c : name)
  {
    const auto letter = static_cast<unsigned char>(c);
    const bool isUpper = std::isupper(letter) != 0;
    if (std::isalnum(letter) == 0 ||
        (isUpper && std::islower(static_cast<unsigned char>(before)) != 0))
    {
      words.emplace_back();
    }
    if (std::isalnum(letter) != 0)
    {
      words.back() += static_cast<char>(std::tolower(letter));
    }
    before = c;
  }
  return words;
}

double RadiusOf(const CheckedOrgan& organ)
{
  return std::cbrt(0.75 * CubicMillimetersPerMilliliter * organ.Measured.Milliliters / Pi);
}

// +1 if the left organs lie at larger x, as in the patient's axes; -1 if most lie the other way.
double DirectionOfPairs(const std::vector<Pair>& pairs, bool isOriented)
{
  if (pairs.size() < 3)
  {
    return isOriented ? 1.0 : 0.0; // a majority of two is none
  }
  int votes = 0;
  for (const Pair& pair : pairs)
  {
    votes += pair.Left->Measured.Centroid.x() > pair.Right->Measured.Centroid.x() ? 1 : -1;
  }
  return votes >= 0 ? 1.0 : -1.0;
}

// Of the left one from the mirror image of the right one, mm.
Vector3 OffsetOf(const Pair& pair, double midline)
{
  const Vector3& left = pair.Left->Measured.Centroid;
  Vector3 mirrored = pair.Right->Measured.Centroid;
  mirrored.x() = 2.0 * midline - mirrored.x();
  return left - mirrored;
}

void MeasurePairs(const std::vector<Pair>& pairs, double midline)
{
  Vector3 usual;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    std::vector<double> offsets;
    for (const Pair& pair : pairs)
    {
      offsets.push_back(OffsetOf(pair, midline)[axis]);
    }
    usual[axis] = UpperMedian(offsets); // of a head that is turned a little
  }
  for (const Pair& pair : pairs)
  {
    const double radius = 0.5 * (RadiusOf(*pair.Left) + RadiusOf(*pair.Right));
    const double moved = (OffsetOf(pair, midline) - usual).norm() / radius;
    const double ratio =
        std::abs(std::log(pair.Left->Measured.Milliliters / pair.Right->Measured.Milliliters));
    for (CheckedOrgan* organ : {pair.Left, pair.Right})
    {
      organ->Measured.Statistics.push_back(
          {"pair", std::max(moved, ratio), organ->Measured.Centroid, moved * radius});
    }
  }
}
} // namespace

NameSide SideOfName(const std::string& name)
{
  NameSide found;
  for (const std::string& word : WordsOf(name))
  {
    const int side = word == "left" || word == "l" || word == "lh" || word == "lt"    ? 1
                     : word == "right" || word == "r" || word == "rh" || word == "rt" ? -1
                                                                                      : 0;
    if (side != 0 && found.Side == 0)
    {
      found.Side = side;
    }
    else
    {
      found.Rest += word + " ";
    }
  }
  return found;
}

void MeasureSides(CheckedCase& patient)
{
  std::map<std::string, Pair> byName;
  for (CheckedOrgan& organ : patient.Organs)
  {
    const NameSide name = SideOfName(organ.Name);
    if (name.Side != 0)
    {
      (name.Side > 0 ? byName[name.Rest].Left : byName[name.Rest].Right) = &organ;
    }
  }
  std::vector<Pair> pairs;
  std::vector<double> middles;
  for (const auto& [name, pair] : byName)
  {
    if (pair.Left != nullptr && pair.Right != nullptr)
    {
      pairs.push_back(pair);
      middles.push_back(0.5 *
                        (pair.Left->Measured.Centroid.x() + pair.Right->Measured.Centroid.x()));
    }
  }
  if (pairs.empty())
  {
    return;
  }
  const double midline = UpperMedian(middles);
  const double direction = DirectionOfPairs(pairs, patient.IsOriented);
  for (const auto& [name, pair] : byName)
  {
    for (const auto& [organ, other, side] :
         {std::tuple(pair.Left, pair.Right, 1.0), std::tuple(pair.Right, pair.Left, -1.0)})
    {
      if (organ != nullptr)
      {
        // From its partner, else from the midline, on which a single organ may lie in part.
        const double from = other != nullptr ? other->Measured.Centroid.x() : midline;
        const double away = direction * side * (organ->Measured.Centroid.x() - from);
        const double least = (other != nullptr ? 0.1 : 0.5) * RadiusOf(*organ);
        organ->Measured.Statistics.push_back(
            {"side", away < -least ? 1.0 : 0.0, organ->Measured.Centroid, -away});
      }
    }
  }
  if (pairs.size() >= 3)
  {
    MeasurePairs(pairs, midline);
  }
}
} // namespace palpate
