#pragma once

#include "LengthText.h"
#include "StudyState.h"
#include "WindowLook.h"

#include <QString>

#include <array>
#include <optional>

namespace palpate
{
/// Scales that error maps can have (mm); none: two voxels of the mask.
constexpr std::array<std::optional<double>, 6> ErrorScales{
    {std::nullopt, 0.5, 1.0, 2.0, 5.0, 10.0}};
QString TextOf(std::optional<double> errorScale);

/// Habits of the user, which belong to the program rather than to a study. Kept by QSettings.
struct Preferences
{
  static constexpr int LargestDegree = 64;

  WindowLook Look = WindowLook::System;
  /// What a left drag does on slices: changes window and level, as in 3D Slicer, or else moves the
  /// crosshair, as in ITK-SNAP.
  bool LeftDragAdjustsWindow = false;
  /// Whether the patient's left is at the left of axial and coronal slices.
  bool IsNeurological = false;
  LengthUnit Unit = LengthUnit::Millimeter; ///< of lengths and positions that are shown
  int Degree = StudyState().Fit.Degree;     ///< of the models of new studies
  std::optional<double> ErrorScale;         ///< of new studies, mm; none: two voxels

  /// Those kept; what is missing or makes no sense is as by default.
  static Preferences Kept();
  void Keep() const;

  /// What a new study begins with.
  StudyState NewStudy() const;
};
} // namespace palpate
