#pragma once

#include "PalpateSessionModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A piece of a chart, in the units of its picture: x to the right, y down.
struct ChartMark
{
  enum class Kind
  {
    Line,       ///< between two points
    Curve,      ///< through all points
    Bar,        ///< between two opposite corners
    Dot,        ///< round a point
    Text,       ///< at a point
    UprightText ///< the same, from the bottom to the top
  };
  enum class Side
  {
    Start,
    Middle,
    End
  };

  Kind What = Kind::Line;
  std::string Style; ///< "bar", "line", "marker", "axis" or "grid"; none of texts
  std::vector<std::pair<double, double>> Points;
  std::string Text;          ///< or, of bars and dots, what they say when they are pointed at
  Side Anchor = Side::Start; ///< of a text, which of it is at the point
};

/// How large a dot is, in the same units.
constexpr double ChartDotRadius = 2.6;

/// The marks as elements of SVG, whose colours are those of their classes.
PALPATESESSION_EXPORT std::string SvgOf(const std::vector<ChartMark>& marks);

/// The same marks elsewhere.
PALPATESESSION_EXPORT std::vector<ChartMark> Shifted(std::vector<ChartMark> marks, double right,
                                                     double down);
} // namespace palpate
