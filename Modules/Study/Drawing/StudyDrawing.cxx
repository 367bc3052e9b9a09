#include "StudyDrawing.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
auto FieldsOf(const StudyDrawing& d)
{
  return std::tie(d.PriorFile, d.KnownId, d.Sigma, d.CenterWorld, d.Touches, d.IsTouchable,
                  d.IsSoftened);
}

int LastStroke(const StudyDrawing& drawing)
{
  int last = 0;
  for (const SurfaceTouch& touch : drawing.Touches)
  {
    last = std::max(last, touch.Stroke);
  }
  return last;
}
} // namespace

bool operator==(const StudyDrawing& a, const StudyDrawing& b)
{
  return FieldsOf(a) == FieldsOf(b);
}

std::size_t SurfaceCount(const StudyDrawing& drawing)
{
  return static_cast<std::size_t>(std::count_if(drawing.Touches.begin(), drawing.Touches.end(),
                                                [](const SurfaceTouch& touch)
                                                { return !touch.IsOutside; }));
}

void SetSigma(StudyDrawing& drawing, double sigma)
{
  for (SurfaceTouch& touch : drawing.Touches)
  {
    touch.Deviation = touch.Deviation == drawing.Sigma ? sigma : touch.Deviation;
  }
  drawing.Sigma = sigma;
}

std::size_t RowCount(const std::vector<SurfaceTouch>& touches)
{
  std::size_t count = 0;
  for (const SurfaceTouch& touch : touches)
  {
    count += touch.Normal ? 3 : 1;
  }
  return count;
}

Status AddTouches(StudyDrawing& drawing, std::vector<SurfaceTouch> touches)
{
  const bool areValid = std::all_of(touches.begin(), touches.end(),
                                    [](const SurfaceTouch& touch) {
                                      return touch.Deviation >= LeastTouchDeviation &&
                                             touch.Deviation <= LargestTouchDeviation;
                                    });
  if (!areValid)
  {
    return Status::Failure("A touch has a standard deviation outside of 0.01 to 100 mm.");
  }
  if (RowCount(drawing.Touches) + RowCount(touches) > MostDrawnRows)
  {
    return Status::Failure("A drawn organ has at most " + std::to_string(MostDrawnRows) +
                           " touches, those with a normal counted thrice: keep it, or complete it "
                           "by palpate complete.");
  }
  int next = LastStroke(drawing) + 1;
  std::map<int, int> strokes; // in the drawing, by those that were given
  for (SurfaceTouch& touch : touches)
  {
    if (touch.Stroke > 0)
    {
      const auto added = strokes.try_emplace(touch.Stroke, next);
      next += added.second ? 1 : 0;
      touch.Stroke = added.first->second;
    }
    if (touch.Normal)
    {
      touch.Normal->normalize();
    }
    drawing.Touches.push_back(std::move(touch));
  }
  return Status::Success();
}

std::vector<SurfaceTouch> TouchesOfStroke(const std::vector<Vector3>& points, double spacing,
                                          double deviation)
{
  std::vector<SurfaceTouch> touches;
  double since = spacing; // along the line, since the last touch
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    since += n > 0 ? (points[n] - points[n - 1]).norm() : 0.0;
    if (since >= spacing)
    {
      touches.push_back({points[n], deviation, std::nullopt, 1});
      since = 0.0;
    }
  }
  if (touches.size() == 1)
  {
    touches.front().Stroke = 0;
  }
  return touches;
}

void RemoveTouch(StudyDrawing& drawing, std::size_t number)
{
  if (number >= drawing.Touches.size())
  {
    return;
  }
  std::vector<SurfaceTouch>& all = drawing.Touches;
  const int stroke = all[number].Stroke;
  if (stroke == 0)
  {
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(number));
    return;
  }
  all.erase(std::remove_if(all.begin(), all.end(),
                           [stroke](const SurfaceTouch& touch) { return touch.Stroke == stroke; }),
            all.end());
}
} // namespace palpate
