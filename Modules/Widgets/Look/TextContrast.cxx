#include "TextContrast.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Of an sRGB component, 0..1.
double Linear(double part)
{
  return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double Luminance(const QColor& color)
{
  return 0.2126 * Linear(color.redF()) + 0.7152 * Linear(color.greenF()) +
         0.0722 * Linear(color.blueF());
}

QColor Mixed(const QColor& color, const QColor& end, double share)
{
  const auto mix = [share](double from, double to) { return from + share * (to - from); };
  return QColor::fromRgbF(mix(color.redF(), end.redF()), mix(color.greenF(), end.greenF()),
                          mix(color.blueF(), end.blueF()));
}
} // namespace

double ContrastRatio(const QColor& one, const QColor& other)
{
  constexpr double Flare = 0.05; // luminance of a screen that shows black
  const auto [darker, lighter] = std::minmax({Luminance(one), Luminance(other)});
  return (lighter + Flare) / (darker + Flare);
}

QColor ReadableOn(const QColor& ground, const QColor& color)
{
  constexpr int Steps = 32;
  const QColor black(Qt::black);
  const QColor white(Qt::white);
  const QColor& end = ContrastRatio(ground, white) > ContrastRatio(ground, black) ? white : black;
  for (int step = 0; step < Steps; ++step)
  {
    QColor mixed = Mixed(color, end, static_cast<double>(step) / Steps);
    if (ContrastRatio(ground, mixed) >= LeastTextContrast)
    {
      return mixed;
    }
  }
  return end;
}
} // namespace palpate
