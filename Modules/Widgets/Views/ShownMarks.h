#pragma once

#include "StudyState.h"

#include "vtkLandmarks.h"
#include "vtkNew.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What a trial of a task shows: named points, and a line; world, mm.
struct TrialMarks
{
  std::vector<StudyLandmark> Points;
  std::vector<Vector3> Line; ///< empty: none
};

/// Landmarks and measurements as all views share them: control points, lines and values.
class ShownMarks
{
public:
  void Show(const StudyState& state);
  /// The open measurement as it would be with one more point, or one that would be made; none:
  /// only what the study has.
  void ShowPreview(const std::optional<StudyMeasurement>& preview);

  /// Touches of an organ, and where to touch it next (world, mm).
  void ShowDrawing(const StudyDrawing& drawing, const std::vector<Vector3>& next);

  /// A closed line with a text, such as the width of a pull (world, mm); none: nothing.
  void ShowRing(const std::vector<Vector3>& ring, const std::string& text);
  void ShowTrial(const TrialMarks& marks);

  void SetLengthUnit(LengthUnit unit);

  vtkLandmarks* Display() const { return this->Shown; }

private:
  void Update();
  void Add(const StudyMeasurement& measurement);
  void AddDrawing();
  void AddTrial();

  vtkNew<vtkLandmarks> Shown;
  LengthUnit Unit = LengthUnit::Millimeter;
  std::vector<StudyLandmark> Landmarks;
  std::vector<StudyMeasurement> Measurements;
  std::optional<StudyMeasurement> Preview;
  StudyDrawing Drawing;
  std::vector<Vector3> Next;
  std::vector<Vector3> Ring;
  std::string RingText;
  TrialMarks Trial;
};
} // namespace palpate
