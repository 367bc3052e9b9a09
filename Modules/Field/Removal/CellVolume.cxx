#include "CellVolume.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int GaussCount = 4;
constexpr std::array<double, GaussCount> GaussNodes{
    {0.069431844202973712, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629}};
constexpr std::array<double, GaussCount> GaussWeights{
    {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}};

double Mean(double a, double b, double u)
{
  return a * (1.0 - u) + b * u;
}

// The part of [0, 1] on which values that are linear between the ends are not negative.
struct Stretch
{
  double From = 0.0;
  double To = 1.0;

  void Cut(double a, double b)
  {
    if (a < 0.0 && b < 0.0)
    {
      this->To = 0.0;
    }
    else if (a < 0.0)
    {
      this->From = std::max(this->From, a / (a - b));
    }
    else if (b < 0.0)
    {
      this->To = std::min(this->To, a / (a - b));
    }
  }
  double Length() const { return std::max(this->To - this->From, 0.0); }
};

// Interpolates between the corners of one face along k.
double OnFace(const double* corners, double u, double v)
{
  return Mean(Mean(corners[0], corners[1], u), Mean(corners[2], corners[3], u), v);
}
} // namespace

double InsidePartOfCell(const CellCorners* values, std::size_t count) noexcept
{
  bool isAll = true;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto [least, most] = std::minmax_element(values[n].begin(), values[n].end());
    if (*most < 0.0)
    {
      return 0.0;
    }
    isAll = isAll && *least >= 0.0;
  }
  if (isAll)
  {
    return 1.0;
  }
  double part = 0.0;
  for (std::size_t i = 0; i < GaussCount; ++i)
  {
    for (std::size_t j = 0; j < GaussCount; ++j)
    {
      Stretch inside;
      for (std::size_t n = 0; n < count; ++n)
      {
        const double* corners = values[n].data();
        inside.Cut(OnFace(corners, GaussNodes[i], GaussNodes[j]),
                   OnFace(corners + 4, GaussNodes[i], GaussNodes[j]));
      }
      part += GaussWeights[i] * GaussWeights[j] * inside.Length();
    }
  }
  return part;
}
} // namespace palpate
