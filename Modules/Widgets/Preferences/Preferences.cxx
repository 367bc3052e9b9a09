#include "Preferences.h"

#include <QSettings>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr const char* LeftDragKey = "left-drag-adjusts-window";
constexpr const char* NeurologicalKey = "neurological";
constexpr const char* CentimetersKey = "centimeters";
constexpr const char* DegreeKey = "degree";
constexpr const char* ErrorScaleKey = "error-scale";
} // namespace

QString TextOf(std::optional<double> errorScale)
{
  return errorScale ? QString("\u00b1%1 mm").arg(*errorScale) : QString("Two voxels of the mask");
}

Preferences Preferences::Kept()
{
  const QSettings settings;
  Preferences kept;
  kept.Look = ChosenLook();
  kept.LeftDragAdjustsWindow = settings.value(LeftDragKey, false).toBool();
  kept.IsNeurological = settings.value(NeurologicalKey, false).toBool();
  const bool isCentimeters = settings.value(CentimetersKey, false).toBool();
  kept.Unit = isCentimeters ? LengthUnit::Centimeter : LengthUnit::Millimeter;
  bool isNumber = false;
  const int degree = settings.value(DegreeKey).toInt(&isNumber);
  if (isNumber && degree >= 0 && degree <= LargestDegree)
  {
    kept.Degree = degree;
  }
  const std::optional<double> scale = settings.value(ErrorScaleKey, 0.0).toDouble();
  if (std::find(ErrorScales.begin(), ErrorScales.end(), scale) != ErrorScales.end())
  {
    kept.ErrorScale = scale;
  }
  return kept;
}

void Preferences::Keep() const
{
  QSettings settings;
  settings.setValue(LeftDragKey, this->LeftDragAdjustsWindow);
  settings.setValue(NeurologicalKey, this->IsNeurological);
  settings.setValue(CentimetersKey, this->Unit == LengthUnit::Centimeter);
  settings.setValue(DegreeKey, this->Degree);
  settings.setValue(ErrorScaleKey, this->ErrorScale.value_or(0.0));
  ChooseLook(this->Look);
}

StudyState Preferences::NewStudy() const
{
  StudyState state;
  state.Fit.Degree = this->Degree;
  state.View.ErrorScale = this->ErrorScale;
  return state;
}
} // namespace palpate
